// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/rival.h"

#include <algorithm>
#include <string>

namespace latchwork::bumper_cars {
namespace {

constexpr double kLeg = 8.0;         // s, at most
constexpr double kArrived = 0.8;     // m
constexpr double kMargin = 1.2;      // m, of places from the walls
constexpr double kHunts = 0.3;       // probability that a leg of an enemy is after the agent
constexpr double kStuckAfter = 1.0;  // s
constexpr double kBackFor = 1.2;     // s
constexpr double kPolite = 2.0;      // m, between centres, at which a friend brakes

Vector NearestPole(const Arena& arena, const Car& car) {
  const auto nearer = [&](const Pole& a, const Pole& b) {
    return Length(a.place - car.place) < Length(b.place - car.place);
  };
  return std::min_element(arena.poles.begin(), arena.poles.end(), nearer)->place;
}

/// Where a place is as seen from the car, left > 0.
double BearingOf(Vector place, const Car& car) {
  const Vector to = place - car.place;
  return WrapAngle(std::atan2(to.y, to.x) - car.heading);
}

}  // namespace

Rival::Rival(std::uint64_t seed, std::size_t car)
    : random_(seed, "rival" + std::to_string(car)), car_(car) {}

void Rival::NextLeg(const Arena& arena) {
  ++leg_;
  leg_left_ = kLeg * random_.Between(0.5, 1.0, leg_, 0);
  place_ = {random_.Between(kMargin, arena.size.x - kMargin, leg_, 1),
            random_.Between(kMargin, arena.size.y - kMargin, leg_, 2)};
  pedal_ = random_.Between(0.3, 0.6, leg_, 3);
  hunts_ = arena.cars[car_].attitude == Attitude::kEnemy && random_.Uniform(leg_, 4) < kHunts;
}

Vector Rival::Target(const Arena& arena) const {
  const Car& car = arena.cars[car_];
  if (!car.has_power() && !arena.poles.empty()) return NearestPole(arena, car);
  return hunts_ ? arena.cars[0].place : place_;
}

bool Rival::StartsBacking(const Car& car, double seconds) {
  stuck_for_ = Length(car.velocity) < 0.15 ? stuck_for_ + seconds : 0;
  if (stuck_for_ < kStuckAfter) return false;
  stuck_for_ = 0;
  backing_left_ = kBackFor;
  return true;
}

Controls Rival::DriveTo(Vector target, double pedal, const Car& car) {
  const double bearing = BearingOf(target, car);
  return {std::abs(bearing) > 1.2 ? std::min(pedal, 0.35) : pedal, 1.5 * bearing};
}

Controls Rival::Decide(const Arena& arena, double seconds) {
  const Car& car = arena.cars[car_];
  leg_left_ -= seconds;
  if (leg_left_ <= 0 || Length(place_ - car.place) < kArrived) NextLeg(arena);
  backing_left_ = std::max(0.0, backing_left_ - seconds);
  if (backing_left_ > 0 || StartsBacking(car, seconds)) {
    return {-0.4, leg_ % 2 == 0 ? 0.8 : -0.8};
  }
  const Car& agent = arena.cars[0];
  const bool polite = car.attitude == Attitude::kFriend &&
                      Length(agent.place - car.place) < kPolite &&
                      std::abs(BearingOf(agent.place, car)) < 1.0;
  if (polite) return {0, car.steer};
  return DriveTo(Target(arena), pedal_, car);
}

}  // namespace latchwork::bumper_cars
