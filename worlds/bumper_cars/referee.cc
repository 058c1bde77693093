// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/referee.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace latchwork::bumper_cars {
namespace {

using State = sdk::Outcome::State;

constexpr double kThrillSpeed = 1.6;  // m/s
constexpr double kSpillEvery = 1.0;   // s; bumps into the same car within count as one
constexpr double kLightestTap = 0.1;  // m/s
constexpr double kPayTime = 2.0;      // s
constexpr double kLeaveTime = 2.0;    // s
constexpr double kGateReach = 1.5;    // m
constexpr double kStanding = 0.1;     // m/s

constexpr double kPush = 0.2;       // m/s, of who pushes
constexpr double kPushedFor = 0.5;  // s

int Count(const std::vector<char>& flags) {
  return static_cast<int>(std::count(flags.begin(), flags.end(), 1));
}

}  // namespace

Referee::Referee(const Rules& rules, std::size_t cars)
    : rules_(rules),
      park_(rules.day ? Park::kAtGate : Park::kRiding),
      rammed_(cars, 0),
      tapped_(cars, 0),
      since_spill_(cars, kSpillEvery),
      since_pushed_(cars, kPushedFor),
      ride_left_(rules.ride_seconds) {}

int Referee::thrills() const { return static_cast<int>(fast_seconds_ + 1e-6); }
int Referee::CountRammed() const { return Count(rammed_); }
int Referee::CountTapped() const { return Count(tapped_); }

void Referee::Note(std::string remark) {
  ++version_;
  remark_ = std::move(remark);
}

void Referee::End(State state, std::string message) {
  if (outcome_.state != State::kRunning) return;
  remark_ = message;
  outcome_ = {state, std::move(message)};
}

void Referee::Step(std::span<const Bump> bumps, const Arena& arena, double seconds) {
  remark_.clear();
  for (double& since : since_spill_) since += seconds;
  for (double& since : since_pushed_) since += seconds;
  for (const Bump& bump : bumps) {
    if (bump.a != 0) continue;
    if (bump.impact.second >= kPush) since_pushed_[bump.b] = 0;
    Judge(bump.b, bump.impact, arena);
  }
  const int before = thrills();
  if (may_drive() && Length(arena.cars[0].velocity) >= kThrillSpeed) fast_seconds_ += seconds;
  if (thrills() != before) ++version_;
  if (rules_.day && park_ == Park::kRiding) {
    ride_left_ -= seconds;
    if (ride_left_ <= 0) RingBell();
  }
  if (!rules_.day) CheckCollisions();
}

bool Referee::WasPushed(std::size_t into) const {
  for (std::size_t car = 0; car < since_pushed_.size(); ++car) {
    if (car != into && since_pushed_[car] < kPushedFor) return true;
  }
  return false;
}

void Referee::Judge(std::size_t car, const Impact& impact, const Arena& arena) {
  const Car& other = arena.cars[car];
  const double speed = impact.first;
  if (other.attitude == Attitude::kFriend) {
    if (speed > rules_.tap_speed && !WasPushed(car)) {
      End(State::kFailed, fmt::format("hit {}, a friend, at {:.2f} m/s", other.driver, speed));
    } else if (speed >= kLightestTap && speed <= rules_.tap_speed && tapped_[car] == 0) {
      tapped_[car] = 1;
      Note(fmt::format("tapped {}, a friend, at {:.2f} m/s", other.driver, speed));
    }
    return;
  }
  if (speed < rules_.ram_speed) return;
  if (since_spill_[car] >= kSpillEvery) {
    ++spills_;
    Note(fmt::format("bumped {} at {:.2f} m/s", other.driver, speed));
  }
  since_spill_[car] = 0;
  if (other.attitude != Attitude::kEnemy || rammed_[car] != 0) return;
  rammed_[car] = 1;
  Note(fmt::format("rammed {}, an enemy, at {:.2f} m/s", other.driver, speed));
}

void Referee::CheckCollisions() {
  if (CountRammed() < rules_.rams || CountTapped() < rules_.taps) return;
  End(State::kReached,
      fmt::format("rammed {} enemies and tapped {} friends", CountRammed(), CountTapped()));
}

bool Referee::RingBell() {
  if (!rules_.day || park_ != Park::kRiding) return false;
  park_ = Park::kOver;
  Note("the bell: the ride is over");
  return true;
}

void Referee::Pay(double seconds) {
  if (park_ != Park::kAtGate) return;
  paying_ += seconds;
  if (paying_ < kPayTime) return;
  park_ = Park::kRiding;
  Note("paid");
}

void Referee::Leave(const Arena& arena, double seconds) {
  const Car& car = arena.cars[0];
  const bool there = Length(arena.gate - car.place) <= kGateReach;
  if (!rules_.day || park_ == Park::kOutside || !there || Length(car.velocity) > kStanding) {
    leaving_ = 0;
    return;
  }
  leaving_ += seconds;
  if (leaving_ >= kLeaveTime) CheckDay();
}

void Referee::CheckDay() {
  const bool over = park_ == Park::kOver;
  park_ = Park::kOutside;
  Note("left");
  if (!over) {
    End(State::kFailed, "left before the ride was over");
  } else if (spills_ < rules_.spills || thrills() < rules_.thrills) {
    End(State::kFailed, fmt::format("left after {} of {} spills and {} of {} thrills", spills_,
                                    rules_.spills, thrills(), rules_.thrills));
  } else {
    End(State::kReached,
        fmt::format("paid, rode with {} spills and {} thrills, left", spills_, thrills()));
  }
}

}  // namespace latchwork::bumper_cars
