// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cleaning/base.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace latchwork::cleaning {

namespace {

constexpr double kLongestMove = 0.01;  // m between two looks for a contact

double Approach(double value, double wanted, double most) {
  return value + std::clamp(wanted - value, -most, most);
}

/// The pose after so many seconds on an arc.
Pose Along(const Pose& pose, double speed, double turn_rate, double dt) {
  const double middle = pose.heading + turn_rate * dt / 2;
  const double half = turn_rate * dt / 2;
  const double chord = half == 0.0 ? 1.0 : std::sin(half) / half;
  return {pose.x + speed * dt * chord * std::cos(middle),
          pose.y + speed * dt * chord * std::sin(middle), WrapAngle(pose.heading + turn_rate * dt)};
}

}  // namespace

double WrapAngle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

void Base::Drive(double speed, double turn_rate) {
  wanted_speed_ = std::clamp(speed, -limits_.max_speed, limits_.max_speed);
  wanted_turn_rate_ = std::clamp(turn_rate, -limits_.max_turn_rate, limits_.max_turn_rate);
}

std::optional<double> Base::Step(double dt, const FloorPlan& plan) {
  speed_ = Approach(speed_, wanted_speed_, limits_.acceleration * dt);
  turn_rate_ = Approach(turn_rate_, wanted_turn_rate_, limits_.turn_acceleration * dt);
  const int moves = std::max(1, static_cast<int>(std::ceil(std::abs(speed_) * dt / kLongestMove)));
  for (int move = 0; move < moves; ++move) {
    const Pose next = Along(pose_, speed_, turn_rate_, dt / moves);
    const auto contact = ContactAt({next.x, next.y}, plan);
    if (contact && speed_ != 0.0) {
      speed_ = 0.0;
      return WrapAngle(*contact - pose_.heading);
    }
    pose_ = next;
    travelled_ += std::abs(speed_) * dt / moves;
  }
  return std::nullopt;
}

/// The direction to the nearest point of what the robot would overlap at a place.
std::optional<double> Base::ContactAt(Point place, const FloorPlan& plan) const {
  if (!plan.Touches(place, limits_.radius)) return std::nullopt;
  double nearest = limits_.radius;
  double direction = 0.0;
  const Tile middle = TileAt(place);
  const int reach = static_cast<int>(limits_.radius / kTile) + 1;
  for (int j = middle.j - reach; j <= middle.j + reach; ++j) {
    for (int i = middle.i - reach; i <= middle.i + reach; ++i) {
      if (plan.IsFloor({i, j})) continue;
      const double dx = std::clamp(place.x, i * kTile, (i + 1) * kTile) - place.x;
      const double dy = std::clamp(place.y, j * kTile, (j + 1) * kTile) - place.y;
      if (std::hypot(dx, dy) >= nearest) continue;
      nearest = std::hypot(dx, dy);
      direction = std::atan2(dy, dx);
    }
  }
  return direction;
}

}  // namespace latchwork::cleaning
