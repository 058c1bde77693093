// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/hanoi/gripper.h"

#include <algorithm>
#include <cmath>

namespace latchwork::hanoi {
namespace {

constexpr double kClose = 1e-9;

/// From `value` towards `goal`, by `step` at most.
double Approach(double value, double goal, double step) {
  return value < goal ? std::min(goal, value + step) : std::max(goal, value - step);
}

}  // namespace

double PegX(int peg) { return (peg + 0.5) * kPegDistance; }

double RaisedHeight(int disks) { return (disks + 2) * kThickness; }

std::optional<int> Gripper::above() const {
  for (int peg = 0; peg < kPegs; ++peg) {
    if (std::abs(x_ - PegX(peg)) < kClose) return peg;
  }
  return std::nullopt;
}

double Gripper::StopHeight(int peg, const Pegs& pegs) const {
  const int below = held_ != 0 ? pegs.Count(peg) : std::max(0, pegs.Count(peg) - 1);
  return below * kThickness;
}

bool Gripper::Down(const Pegs& pegs) const {
  const auto peg = above();
  return peg && z_ <= StopHeight(*peg, pegs) + kClose;
}

Gripper::Event Gripper::Step(const Command& command, double seconds, bool slips, Pegs& pegs) {
  if (command != last_) fingers_ = 0;
  last_ = command;
  refusal_.clear();
  switch (command.kind) {
    case Command::Kind::kMoveTo:
      MoveTo(command.peg, seconds);
      break;
    case Command::Kind::kLower:
      Lower(seconds, pegs);
      break;
    case Command::Kind::kRaise:
      z_ = Approach(z_, raised_z_, limits_.lift_speed * seconds);
      break;
    case Command::Kind::kGrasp:
      return Close(seconds, slips, pegs);
    case Command::Kind::kRelease:
      return Open(seconds, pegs);
    case Command::Kind::kNone:
      break;
  }
  return Event::kNone;
}

void Gripper::MoveTo(int peg, double seconds) {
  if (!raised()) {
    refusal_ = "cannot move to the side while it is lowered";
    return;
  }
  x_ = Approach(x_, PegX(peg), limits_.travel_speed * seconds);
}

void Gripper::Lower(double seconds, const Pegs& pegs) {
  const auto peg = above();
  if (!peg) {
    refusal_ = "cannot be lowered between the pegs";
    return;
  }
  z_ = Approach(z_, StopHeight(*peg, pegs), limits_.lift_speed * seconds);
}

Gripper::Event Gripper::Close(double seconds, bool slips, Pegs& pegs) {
  const auto peg = above();
  const int disk = peg ? pegs.Top(*peg) : 0;
  if (held_ != 0 || disk == 0 || !Down(pegs)) {
    refusal_ = "has nothing to grasp";
    return Event::kNone;
  }
  fingers_ += seconds;
  if (fingers_ < limits_.grip_time - kClose) return Event::kNone;
  fingers_ = 0;
  if (slips) return Event::kSlipped;
  held_ = disk;
  pegs.Lift(disk);
  return Event::kGrasped;
}

Gripper::Event Gripper::Open(double seconds, Pegs& pegs) {
  if (held_ == 0 || !Down(pegs)) {
    refusal_ = "has nothing to release, or is not down";
    return Event::kNone;
  }
  fingers_ += seconds;
  if (fingers_ < limits_.grip_time - kClose) return Event::kNone;
  fingers_ = 0;
  if (!pegs.Takes(*above(), held_)) return Event::kPutOnSmaller;
  pegs.Put(held_, *above());
  held_ = 0;
  return Event::kReleased;
}

}  // namespace latchwork::hanoi
