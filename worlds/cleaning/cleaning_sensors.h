// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CLEANING_CLEANING_SENSORS_H_
#define LATCHWORK_CLEANING_CLEANING_SENSORS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/random.h"
#include "latchwork/sdk/world.h"
#include "worlds/cleaning/cleaning_state.h"

namespace latchwork::cleaning {

/// How far the robot's senses go, and how they err.
struct SensorOptions {
  double sight = 1.1;
  std::uint64_t ticks_per_picture = 2;
  double overlooked = 0;
  double pose_noise = 0;
  double heading_noise = 0;
  double range_noise = 0;
};

/// Turns the state of the world into what the robot senses. Range finders: eight, to 2 m.
class CleaningSensors {
 public:
  CleaningSensors(const SensorOptions& options, std::uint64_t seed, logic::SymbolTable& symbols);

  void Observe(std::uint64_t tick, const CleaningState& state, std::span<sdk::Batch> sensors);

 private:
  using Facts = std::vector<logic::Fact>;

  void SayRobot(const CleaningState& state, Facts& facts) const;
  void SayPose(std::uint64_t tick, const CleaningState& state, Facts& facts) const;
  void SayView(std::uint64_t tick, const CleaningState& state, Facts& facts);
  void SayRow(std::uint64_t tick, const CleaningState& state, int j, Facts& facts) const;
  bool MakesOut(const CleaningState& state, Tile tile) const;
  logic::Symbol StateOf(std::uint64_t tick, const CleaningState& state, Tile tile) const;
  void SayRanges(std::uint64_t tick, const CleaningState& state, Facts& facts) const;
  void SayTouch(const CleaningState& state, Facts& facts) const;
  void SayPower(const CleaningState& state, Facts& facts) const;

  SensorOptions options_;
  sdk::RandomStream pose_random_;
  sdk::RandomStream view_random_;
  sdk::RandomStream range_random_;
  std::int64_t pictures_ = 0;
  logic::Symbol tile_size_, dock_, pose_, picture_, row_in_view_, tile_, dirty_, clean_, blocked_,
      range_, bump_, ahead_, left_, right_, behind_, battery_, charging_;
};

}  // namespace latchwork::cleaning

#endif  // LATCHWORK_CLEANING_CLEANING_SENSORS_H_
