// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/traffic_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "worlds/traffic/reward.h"
#include "worlds/traffic/traffic_contract.h"

namespace latchwork::traffic {

namespace {

using State = sdk::Outcome::State;

constexpr double kRolling = -0.2;     // m/s^2 with nobody at the pedals
constexpr double kHardBraking = 4.0;  // m/s^2
constexpr double kSurpriseSeconds = 2.0;
constexpr double kLongestTick = 0.25;  // s

RoadSetup RoadOf(const sdk::WorldSetup& setup, const sdk::Parameters& parameters) {
  return {.length = parameters.Real("ring"),
          .lanes = static_cast<int>(parameters.Integer("lanes")),
          .density = parameters.Real("density"),
          .trucks = parameters.Real("trucks"),
          .speed_limit = parameters.Real("speed_limit"),
          .dt = setup.tick_seconds,
          .seed = setup.seed};
}

}  // namespace

TrafficWorld::TrafficWorld()
    : contract_(TrafficContract()), parameters_(TrafficParameters()), events_(TrafficEvents()) {}

logic::Diagnostics TrafficWorld::Load(const sdk::WorldSetup& setup,
                                      const sdk::Parameters& parameters) {
  if (setup.tick_seconds > kLongestTick) {
    return {{{}, "traffic needs a tick of at most 250ms", "set the agent's tick to 100ms", {}}};
  }
  tick_seconds_ = setup.tick_seconds;
  accelerate_ = setup.symbols->Intern("accelerate");
  aim_ = setup.symbols->Intern("aim");
  exit_ = parameters.Real("exit");
  trip_seconds_ = parameters.Real("slack") * exit_ / parameters.Real("speed_limit");
  brakings_ = parameters.Real("brakings");
  trips_ = parameters.Integer("trips");
  end_at_failure_ = parameters.Boolean("end_at_failure");
  sight_ = {parameters.Real("sight_range"), parameters.Real("distance_noise"),
            parameters.Real("speed_noise")};
  sensors_.emplace(*setup.symbols, setup.seed);
  surprises_.emplace(setup.seed, "surprises");
  trip_ = {};
  counts_ = {};
  outcome_ = {};
  road_.emplace(RoadOf(setup, parameters), *setup.symbols);
  warm_up_ticks_ = static_cast<std::uint64_t>(parameters.Real("warm_up") / tick_seconds_);
  for (std::uint64_t tick = 0; tick < warm_up_ticks_; ++tick) road_->Step(tick, std::nullopt);
  picture_.Begin(road_->setup(), exit_);
  return {};
}

void TrafficWorld::Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) {
  sensors_->Observe(tick, *road_, trip_, exit_, sight_, sensors);
}

void TrafficWorld::Apply(std::uint64_t /*tick*/, std::span<const sdk::Batch> effectors) {
  bool told = false;
  command_ = kRolling;
  Car& car = road_->cars()[Road::kAgent];
  for (const logic::Fact& fact : effectors[kDrive].facts) {
    if (fact.arity() != 1 || !fact.argument(0).is_number()) continue;
    const double value = fact.argument(0).number();
    if (!std::isfinite(value)) continue;
    if (fact.predicate() == accelerate_) {
      // Of several commands the weakest acceleration counts.
      command_ = told ? std::min(command_, value) : value;
      told = true;
    } else if (fact.predicate() == aim_) {
      const int lane =
          static_cast<int>(std::clamp(value, -1.0, static_cast<double>(road_->setup().lanes)));
      if (lane != car.aim) ++counts_.lane_changes;
      car.aim = lane;
    }
  }
}

void TrafficWorld::Step(std::uint64_t tick) {
  if (outcome_.state != State::kRunning) return;
  SurpriseByBraking(tick);
  const double braking_before = -car().acceleration;
  road_->Step(warm_up_ticks_ + tick, command_);
  ++counts_.ticks;
  ++counts_.trip_ticks;
  trip_.travelled += car().speed * tick_seconds_;
  counts_.distance += car().speed * tick_seconds_;
  Judge();
  Count(braking_before);
  picture_.Remember(Seconds(counts_.ticks), counts_.distance, trip_.travelled, *road_);
  CheckTrip();
  counts_.reward += trip_.reward;
}

void TrafficWorld::SurpriseByBraking(std::uint64_t tick) {
  const double chance = brakings_ / 60 * tick_seconds_;
  if (surprises_->Uniform(tick) < chance) BrakeLeader(kSurpriseSeconds);
}

void TrafficWorld::Brake(Car& car, double seconds) const {
  car.brakes_until =
      warm_up_ticks_ + counts_.ticks + static_cast<std::uint64_t>(seconds / tick_seconds_);
}

bool TrafficWorld::BrakeLeader(double seconds) {
  const auto leader = road_->Ahead(Road::kAgent, car().lane());
  if (leader) Brake(road_->cars()[leader->car], seconds);
  return leader.has_value();
}

bool TrafficWorld::BrakeNamed(const logic::Term& name, double seconds) {
  for (std::size_t i = Road::kAgent + 1; i < road_->cars().size(); ++i) {
    Car& car = road_->cars()[i];
    if (logic::Term::Constant(car.name) != name) continue;
    Brake(car, seconds);
    return true;
  }
  return false;
}

void TrafficWorld::Judge() {
  Moment moment{.speed = car().speed,
                .speed_limit = road_->setup().speed_limit,
                .acceleration = car().acceleration,
                .side_speed = car().side_speed,
                .headway = {},
                .follower_braking = 0};
  for (int lane = 0; lane < road_->setup().lanes; ++lane) {
    if (!car().Occupies(lane)) continue;
    const auto ahead = road_->Ahead(Road::kAgent, lane);
    const auto behind = road_->Behind(Road::kAgent, lane);
    if (ahead && car().speed > 1) {
      const double headway = std::max(0.0, ahead->gap / car().speed);
      moment.headway = std::min(headway, moment.headway.value_or(headway));
    }
    if (behind && behind->gap < 50) {
      const double braking = -road_->cars()[behind->car].acceleration;
      moment.follower_braking = std::max(moment.follower_braking, braking);
    }
  }
  if (moment.headway) counts_.least_headway = std::min(counts_.least_headway, *moment.headway);
  trip_.reward = RewardRate(moment) * tick_seconds_;
}

void TrafficWorld::Count(double braking_before) {
  if (braking_before <= kHardBraking && -car().acceleration > kHardBraking) {
    ++counts_.hard_brakings;
  }
  counts_.others_touching =
      std::max<std::uint64_t>(counts_.others_touching, road_->TouchingOthers());
}

void TrafficWorld::CheckTrip() {
  const double left_edge = (road_->setup().lanes - 0.5) * kLaneWidth;
  if (const auto touched = road_->Touched()) {
    ++counts_.collisions;
    Fail(fmt::format("collision with {}", road_->cars()[*touched].name.name()), kCollisionReward,
         true);
  } else if (car().y < -kLaneWidth / 2 || car().y > left_edge) {
    Fail("left the road", kCollisionReward, true);
  } else if (trip_.travelled >= exit_) {
    CheckExit();
  } else if (Seconds(counts_.trip_ticks) >= trip_seconds_) {
    Fail(fmt::format("{:.0f} m from the exit after {:.0f} s", exit_ - trip_.travelled,
                     trip_seconds_),
         kMissedReward, false);
  }
}

void TrafficWorld::CheckExit() {
  if (car().lane() == 0 && !car().Occupies(1)) {
    Arrive();
  } else {
    Fail(fmt::format("missed the exit, in lane {}", car().lane()), kMissedReward, false);
  }
}

void TrafficWorld::Arrive() {
  ++counts_.arrived;
  trip_.reward += kArrivedReward;
  if (trip_.number == trips_) {
    outcome_ = counts_.failed == 0
                   ? sdk::Outcome{State::kReached, fmt::format("reached the exit after {:.1f} s",
                                                               Seconds(counts_.trip_ticks))}
                   : sdk::Outcome{State::kFailed,
                                  fmt::format("{} of {} trips failed", counts_.failed, trips_)};
    return;
  }
  BeginTrip();
}

void TrafficWorld::Fail(std::string message, double reward, bool place_anew) {
  ++counts_.failed;
  trip_.reward += reward;
  if (end_at_failure_) {
    outcome_ = {State::kFailed, std::move(message)};
    return;
  }
  if (place_anew) road_->PlaceAgent();
  if (trip_.number == trips_) {
    outcome_ = {State::kFailed, fmt::format("{} of {} trips failed", counts_.failed, trips_)};
    return;
  }
  BeginTrip();
}

void TrafficWorld::BeginTrip() {
  ++trip_.number;
  trip_.travelled = 0;
  counts_.trip_ticks = 0;
}

logic::Diagnostics TrafficWorld::HandleEvent(std::uint64_t /*tick*/, const logic::Fact& event) {
  const auto name = event.predicate().name();
  const auto wrong = [](std::string text) {
    return logic::Diagnostics{{{}, std::move(text), {}, {}}};
  };
  if (event.arity() == 0 || !event.argument(event.arity() - 1).is_number()) {
    return wrong("the traffic knows no event '" + logic::ToString(event) + "'");
  }
  const double value = event.argument(event.arity() - 1).number();
  if (!(value >= 0 && value <= 1000)) return wrong("the number must be between 0 and 1000");
  if (name == "sight" && event.arity() == 1) {
    sight_.range = value;
    return {};
  }
  if (name == "leader_brakes" && event.arity() == 1) {
    return BrakeLeader(value) ? logic::Diagnostics() : wrong("there is no car ahead");
  }
  if (name == "brakes" && event.arity() == 2) {
    return BrakeNamed(event.argument(0), value)
               ? logic::Diagnostics()
               : wrong("no other car has the name " + logic::ToString(event.argument(0)));
  }
  return wrong("the traffic knows no event '" + logic::ToString(event) + "'");
}

std::vector<std::pair<std::string, double>> TrafficWorld::Measures() const {
  const double seconds = Seconds(counts_.ticks);
  return {{"collisions", static_cast<double>(counts_.collisions)},
          {"time_s", seconds},
          {"distance_m", counts_.distance},
          {"mean_speed_m_s", seconds > 0 ? counts_.distance / seconds : 0},
          {"trips_arrived", static_cast<double>(counts_.arrived)},
          {"trips_failed", static_cast<double>(counts_.failed)},
          {"lane_changes", static_cast<double>(counts_.lane_changes)},
          {"hard_brakings", static_cast<double>(counts_.hard_brakings)},
          {"least_headway_s", counts_.least_headway},
          {"reward", counts_.reward},
          {"others_touching", static_cast<double>(counts_.others_touching)}};
}

std::vector<std::filesystem::path> TrafficWorld::Draw(const std::filesystem::path& folder) const {
  return picture_.Draw(folder);
}

}  // namespace latchwork::traffic
