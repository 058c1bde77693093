// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BUMPER_CARS_BUMPER_WORLD_H_
#define LATCHWORK_BUMPER_CARS_BUMPER_WORLD_H_

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/world.h"
#include "worlds/bumper_cars/arena.h"
#include "worlds/bumper_cars/bumper_picture.h"
#include "worlds/bumper_cars/bumper_sensors.h"
#include "worlds/bumper_cars/referee.h"
#include "worlds/bumper_cars/rival.h"

namespace latchwork::bumper_cars {

/// An arena of bumper cars, one of them the agent's. Two tasks: to ram the enemies and tap the
/// friends among the drivers, or to have a day of it: pay, ride with spills and thrills, leave.
/// Hitting a friend hard ends either. Thread rule: used by one thread.
class BumperWorld final : public sdk::World {
 public:
  BumperWorld();

  const sdk::Contract& contract() const override { return contract_; }
  std::span<const sdk::ParameterSpec> parameters() const override { return parameters_; }
  std::span<const sdk::PredicateSpec> events() const override { return events_; }

  logic::Diagnostics Load(const sdk::WorldSetup& setup, const sdk::Parameters& parameters) override;
  void Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) override;
  void Apply(std::uint64_t tick, std::span<const sdk::Batch> effectors) override;
  void Step(std::uint64_t tick) override;
  logic::Diagnostics HandleEvent(std::uint64_t tick, const logic::Fact& event) override;

  sdk::Outcome outcome() const override { return referee_->outcome(); }
  std::vector<std::pair<std::string, double>> Measures() const override;
  std::vector<std::filesystem::path> Draw(const std::filesystem::path& folder) const override;

  /// For tests; after a successful Load only.
  Arena& arena() { return arena_; }
  const Referee& referee() const { return *referee_; }

 private:
  struct Counts {
    std::uint64_t ticks = 0;
    std::uint64_t bumps = 0;
    double distance = 0;
    double without_power = 0;
  };

  void Remark(std::string text);
  double Seconds() const { return static_cast<double>(counts_.ticks) * tick_seconds_; }

  sdk::Contract contract_;
  std::vector<sdk::ParameterSpec> parameters_;
  std::vector<sdk::PredicateSpec> events_;
  Arena arena_;
  std::optional<Referee> referee_;
  std::optional<BumperSensors> sensors_;
  std::vector<Rival> rivals_;
  std::vector<Controls> controls_;
  bool pays_ = false;
  bool leaves_ = false;
  double tick_seconds_ = 0.1;
  Counts counts_;
  Film film_;
};

}  // namespace latchwork::bumper_cars

#endif  // LATCHWORK_BUMPER_CARS_BUMPER_WORLD_H_
