// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TRAFFIC_TRAFFIC_SENSORS_H_
#define LATCHWORK_TRAFFIC_TRAFFIC_SENSORS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/random.h"
#include "latchwork/sdk/world.h"
#include "worlds/traffic/road.h"

namespace latchwork::traffic {

/// What the agent's car knows of itself that the road does not.
struct TripState {
  std::int64_t number = 1;
  double travelled = 0;  ///< m
  double reward = 0;     ///< of the last tick
};

struct Sight {
  double range = 150;         ///< m
  double distance_noise = 0;  ///< m
  double speed_noise = 0;     ///< m/s
};

/// Says what the agent's car sees, as facts.
class TrafficSensors {
 public:
  TrafficSensors(logic::SymbolTable& symbols, std::uint64_t seed);

  void Observe(std::uint64_t tick, const Road& road, const TripState& trip, double exit,
               const Sight& sight, std::span<sdk::Batch> sensors);

 private:
  using Facts = std::vector<logic::Fact>;
  void SaySelf(const Road& road, const TripState& trip, double exit, Facts& facts) const;
  void SayCars(std::uint64_t tick, const Road& road, const Sight& sight, Facts& facts) const;
  void SaySeen(std::uint64_t tick, const Road& road, const Sight& sight, int lane, bool ahead,
               Facts& facts) const;
  void SayRoad(const RoadSetup& setup, Facts& facts) const;

  logic::Symbol my_lane_, my_aim_, my_offset_, in_lane_, my_speed_, exit_in_, trip_;
  logic::Symbol ahead_, behind_, beside_;
  logic::Symbol lane_, left_of_, speed_limit_;
  logic::Symbol reward_;
  sdk::RandomStream noise_;
  bool first_ = true;
};

}  // namespace latchwork::traffic

#endif  // LATCHWORK_TRAFFIC_TRAFFIC_SENSORS_H_
