// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/elevator.h"

#include <algorithm>
#include <cmath>

namespace latchwork::office {

namespace {

int Ticks(double seconds, double tick_seconds) {
  return std::max(1, static_cast<int>(std::lround(seconds / tick_seconds)));
}

}  // namespace

Elevator::Elevator(const ElevatorOptions& options, int floors, double tick_seconds,
                   std::uint64_t seed, std::string_view name)
    : door_ticks_(Ticks(options.door_time, tick_seconds)),
      dwell_ticks_(Ticks(options.dwell_time, tick_seconds)),
      floor_ticks_(Ticks(options.floor_time, tick_seconds)),
      call_probability_(options.calls_per_hour * tick_seconds / 3600.0),
      random_(seed, name),
      calls_(static_cast<std::size_t>(floors), 0),
      strangers_(static_cast<std::size_t>(floors), 0) {}

void Elevator::Call(int floor) {
  if (floor >= 0 && static_cast<std::size_t>(floor) < calls_.size()) {
    calls_[static_cast<std::size_t>(floor)] = 1;
  }
}

void Elevator::OtherPeople(std::uint64_t tick) {
  if (random_.Uniform(tick, 0) >= call_probability_) return;
  const auto floor = random_.Index(calls_.size(), tick, 1);
  calls_[floor] = 1;
  strangers_[floor] = 1;
}

void Elevator::SendPassenger(std::uint64_t tick) {
  char& waiting = strangers_[static_cast<std::size_t>(floor_)];
  if (waiting != 0) Call(static_cast<int>(random_.Index(calls_.size(), tick, 2)));
  waiting = 0;
}

bool Elevator::Step(std::uint64_t tick, bool curtain_broken, bool occupied) {
  OtherPeople(tick);
  if (direction_ != 0) return Travel(occupied);
  StepDoor(tick, curtain_broken, occupied);
  return false;
}

bool Elevator::Travel(bool occupied) {
  if (--timer_ > 0) return false;
  floor_ += direction_;
  const bool stops = IsCalled(floor_) || !in_service_ || !NextCall();
  if (!stops) {
    timer_ = floor_ticks_;
    return true;
  }
  last_direction_ = direction_;
  direction_ = 0;
  if (IsCalled(floor_) || occupied) {
    door_ = Door::kOpening;
    timer_ = door_ticks_;
  }
  return true;
}

void Elevator::StepDoor(std::uint64_t tick, bool curtain_broken, bool occupied) {
  switch (door_) {
    case Door::kClosed:
      Serve();
      if (!in_service_ && occupied) {
        door_ = Door::kOpening;
        timer_ = door_ticks_;
      }
      return;
    case Door::kOpening:
      if (--timer_ > 0) return;
      door_ = Door::kOpen;
      shut_ = false;
      timer_ = dwell_ticks_;
      SendPassenger(tick);
      return;
    case Door::kOpen:
      if (IsCalled(floor_) || curtain_broken || (!in_service_ && occupied)) timer_ = dwell_ticks_;
      Clear(floor_);
      if (--timer_ > 0) return;
      door_ = Door::kClosing;
      timer_ = door_ticks_;
      return;
    case Door::kClosing:
      if (curtain_broken || IsCalled(floor_)) {
        door_ = Door::kOpening;
        timer_ = std::max(1, door_ticks_ - timer_);
      } else if (--timer_ <= 0) {
        door_ = Door::kClosed;
        shut_ = true;
      }
      return;
  }
}

void Elevator::Serve() {
  if (!in_service_) return;
  const auto next = NextCall();
  if (!next) return;
  if (*next == floor_) {
    door_ = Door::kOpening;
    timer_ = door_ticks_;
  } else {
    direction_ = *next > floor_ ? 1 : -1;
    timer_ = floor_ticks_;
  }
}

std::optional<int> Elevator::NextCall() const {
  // The nearest call in the direction of travel, else the nearest behind (the elevator algorithm).
  if (IsCalled(floor_)) return floor_;
  const int ahead = direction_ != 0 ? direction_ : last_direction_;
  const int count = static_cast<int>(calls_.size());
  for (const int way : {ahead, -ahead}) {
    for (int floor = floor_ + way; floor >= 0 && floor < count; floor += way) {
      if (IsCalled(floor)) return floor;
    }
  }
  return std::nullopt;
}

}  // namespace latchwork::office
