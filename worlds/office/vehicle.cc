// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/vehicle.h"

#include <algorithm>
#include <cmath>

#include "worlds/office/collision.h"

namespace latchwork::office {

namespace {

/// Moves `value` towards `target` by no more than `limit`.
double Approach(double value, double target, double limit) {
  return value + std::clamp(target - value, -limit, limit);
}

}  // namespace

void Vehicle::Place(const Pose& pose) {
  pose_ = pose;
  pose_.heading = WrapAngle(pose.heading);
  speed_ = turn_rate_ = travelled_ = wanted_speed_ = 0.0;
  wanted_heading_.reset();
}

void Vehicle::Turn(std::optional<double> angle) {
  if (angle) {
    wanted_heading_ = WrapAngle(pose_.heading + *angle);
  } else {
    wanted_heading_.reset();
  }
}

double Vehicle::WantedTurnRate() const {
  if (!wanted_heading_) return 0.0;
  const double rest = WrapAngle(*wanted_heading_ - pose_.heading);
  // Slower than the brakes would allow, so that a step of finite length does not overshoot.
  const double rate =
      std::min(options_.max_turn_rate, std::sqrt(options_.turn_acceleration * std::abs(rest)));
  return std::copysign(std::min(rate, 8.0 * std::abs(rest)), rest);
}

void Vehicle::Accelerate(double dt) {
  const double target = std::clamp(wanted_speed_, 0.0, options_.max_speed);
  speed_ =
      Approach(speed_, target, (target < speed_ ? options_.brake : options_.acceleration) * dt);
  turn_rate_ = Approach(turn_rate_, WantedTurnRate(), options_.turn_acceleration * dt);
}

Pose Vehicle::Advance(double dt) const {
  const double turned = turn_rate_ * dt;
  // The chord of the arc: exact, and well conditioned when it is nearly straight.
  const double half = turned / 2.0;
  const double shrink = std::abs(half) < 1e-4 ? 1.0 - half * half / 6.0 : std::sin(half) / half;
  const double chord = speed_ * dt * shrink;
  return {pose_.x + chord * std::cos(pose_.heading + half),
          pose_.y + chord * std::sin(pose_.heading + half), WrapAngle(pose_.heading + turned)};
}

std::optional<Contact> Vehicle::Touches(const FloorMap& map, std::span<const Disc> discs,
                                        const Pose& pose) const {
  if (FindContact(map, PointOf(pose), options_.radius)) return Contact{PointOf(pose_), "a wall"};
  for (const Disc& disc : discs) {
    const double gap = Distance(disc.centre, PointOf(pose)) - disc.radius - options_.radius;
    const double before = Distance(disc.centre, PointOf(pose_)) - disc.radius - options_.radius;
    if (gap < 0.0 && gap < before) return Contact{PointOf(pose_), "a person"};
  }
  return std::nullopt;
}

std::optional<Contact> Vehicle::Step(const FloorMap& map, std::span<const Disc> discs) {
  const double finest = map.resolution() / 8.0;
  const int steps = std::max(5, static_cast<int>(std::ceil(options_.max_speed * dt_ / finest)));
  const double dt = dt_ / steps;
  for (int i = 0; i < steps; ++i) {
    Accelerate(dt);
    const Pose next = Advance(dt);
    if (speed_ > 0.0) {
      if (auto contact = Touches(map, discs, next)) {
        speed_ = 0.0;
        turn_rate_ = 0.0;
        return contact;
      }
    }
    travelled_ += speed_ * dt;
    pose_ = next;
  }
  return std::nullopt;
}

}  // namespace latchwork::office
