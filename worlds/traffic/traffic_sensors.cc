// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/traffic_sensors.h"

#include <algorithm>

#include "worlds/traffic/traffic_contract.h"

namespace latchwork::traffic {

using logic::Fact;
using logic::Term;

TrafficSensors::TrafficSensors(logic::SymbolTable& symbols, std::uint64_t seed)
    : my_lane_(symbols.Intern("my_lane")),
      my_aim_(symbols.Intern("my_aim")),
      my_offset_(symbols.Intern("my_offset")),
      in_lane_(symbols.Intern("in_lane")),
      my_speed_(symbols.Intern("my_speed")),
      exit_in_(symbols.Intern("exit_in")),
      trip_(symbols.Intern("trip")),
      ahead_(symbols.Intern("ahead")),
      behind_(symbols.Intern("behind")),
      beside_(symbols.Intern("beside")),
      lane_(symbols.Intern("lane")),
      left_of_(symbols.Intern("left_of")),
      speed_limit_(symbols.Intern("speed_limit")),
      reward_(symbols.Intern("reward")),
      noise_(seed, "sight") {}

void TrafficSensors::Observe(std::uint64_t tick, const Road& road, const TripState& trip,
                             double exit, const Sight& sight, std::span<sdk::Batch> sensors) {
  for (std::size_t port = 0; port < sensors.size(); ++port) {
    sensors[port].updated = first_ || port != kRoad;
    if (sensors[port].updated) sensors[port].facts.clear();
  }
  SaySelf(road, trip, exit, sensors[kSelf].facts);
  SayCars(tick, road, sight, sensors[kCars].facts);
  if (first_) SayRoad(road.setup(), sensors[kRoad].facts);
  sensors[kReward].facts.push_back(Fact(reward_, {Term::Real(trip.reward)}));
  first_ = false;
}

void TrafficSensors::SaySelf(const Road& road, const TripState& trip, double exit,
                             Facts& facts) const {
  const Car& car = road.cars()[Road::kAgent];
  facts.push_back(Fact(my_lane_, {Term::Integer(car.lane())}));
  facts.push_back(Fact(my_aim_, {Term::Integer(car.aim)}));
  facts.push_back(Fact(my_offset_, {Term::Real(car.y - car.lane() * kLaneWidth)}));
  for (int lane = 0; lane < road.setup().lanes; ++lane) {
    if (car.Occupies(lane)) facts.push_back(Fact(in_lane_, {Term::Integer(lane)}));
  }
  facts.push_back(Fact(my_speed_, {Term::Real(car.speed)}));
  facts.push_back(Fact(exit_in_, {Term::Real(exit - trip.travelled)}));
  facts.push_back(Fact(trip_, {Term::Integer(trip.number)}));
}

void TrafficSensors::SayCars(std::uint64_t tick, const Road& road, const Sight& sight,
                             Facts& facts) const {
  for (int lane = 0; lane < road.setup().lanes; ++lane) {
    SaySeen(tick, road, sight, lane, true, facts);
    SaySeen(tick, road, sight, lane, false, facts);
  }
}

void TrafficSensors::SaySeen(std::uint64_t tick, const Road& road, const Sight& sight, int lane,
                             bool ahead, Facts& facts) const {
  const auto seen = ahead ? road.Ahead(Road::kAgent, lane) : road.Behind(Road::kAgent, lane);
  if (!seen || seen->gap > sight.range) return;
  const Car& other = road.cars()[seen->car];
  if (seen->gap <= 0) {
    facts.push_back(Fact(beside_, {Term::Integer(lane), Term::Constant(other.name)}));
    return;
  }
  const std::uint64_t draw = 4 * static_cast<std::uint64_t>(lane) + (ahead ? 0 : 2);
  const double gap = seen->gap + sight.distance_noise * noise_.Gaussian(tick, draw);
  const double speed = other.speed - road.cars()[Road::kAgent].speed +
                       sight.speed_noise * noise_.Gaussian(tick, draw + 1);
  facts.push_back(
      Fact(ahead ? ahead_ : behind_, {Term::Integer(lane), Term::Constant(other.name),
                                      Term::Real(std::max(gap, 0.0)), Term::Real(speed)}));
}

void TrafficSensors::SayRoad(const RoadSetup& setup, Facts& facts) const {
  for (int lane = 0; lane < setup.lanes; ++lane) {
    facts.push_back(Fact(lane_, {Term::Integer(lane)}));
    if (lane > 0) facts.push_back(Fact(left_of_, {Term::Integer(lane), Term::Integer(lane - 1)}));
  }
  facts.push_back(Fact(speed_limit_, {Term::Real(setup.speed_limit)}));
}

}  // namespace latchwork::traffic
