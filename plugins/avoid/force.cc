// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/avoid/force.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace latchwork::avoid {
namespace {

// Nearer than this an object does not repel more: a reading of 0 must not become infinite.
constexpr double kLeastGap = 0.04;
constexpr double kLeastDistance = 0.1;

struct Vector {
  double x = 0.0;
  double y = 0.0;
};

Vector FromPolar(double length, double direction) {
  return {length * std::cos(direction), length * std::sin(direction)};
}

void AddTo(Vector& sum, Vector term) {
  sum.x += term.x;
  sum.y += term.y;
}

Vector PushOf(const ForceLaw& law, std::span<const RelativeObject> objects) {
  Vector sum;
  for (const RelativeObject& object : objects) {
    if (!object.is_virtual) continue;
    AddTo(sum, FromPolar(-law.push / std::max(object.distance, kLeastDistance), object.direction));
  }
  return sum;
}

double RepulsionOf(const ForceLaw& law, const RelativeObject& object) {
  const double gap = std::max(object.distance - law.robot_radius, kLeastGap);
  return gap < law.influence ? law.repulsion * (law.influence / gap - 1.0) : 0.0;
}

// Across the line of sight, away from the side on which the object lies as seen along the push.
Vector Circulation(double strength, double direction, double push_direction) {
  const double off = std::remainder(direction - push_direction, 2.0 * std::numbers::pi);
  const double ahead = std::max(std::cos(off), 0.0);
  const double side = off >= 0.0 ? -1.0 : 1.0;
  return FromPolar(strength * ahead, direction + side * std::numbers::pi / 2.0);
}

}  // namespace

Force SumForces(const ForceLaw& law, std::span<const RelativeObject> objects) {
  const Vector push = PushOf(law, objects);
  const bool pushed = push.x != 0.0 || push.y != 0.0;
  const double push_direction = std::atan2(push.y, push.x);
  Vector sum = push;
  for (const RelativeObject& object : objects) {
    const double strength = object.is_virtual ? 0.0 : RepulsionOf(law, object);
    if (strength <= 0.0) continue;
    AddTo(sum, FromPolar(-strength, object.direction));
    if (pushed) {
      AddTo(sum, Circulation(law.circulation * strength, object.direction, push_direction));
    }
  }
  const double strength = std::hypot(sum.x, sum.y);
  return {strength, strength > 0.0 ? std::atan2(sum.y, sum.x) : 0.0};
}

double FreeAhead(double robot_radius, double margin, double half_cone, double horizon,
                 std::span<const RelativeObject> objects) {
  const double reach = robot_radius + margin;
  double least = horizon;
  for (const RelativeObject& object : objects) {
    if (object.is_virtual) continue;
    const double off = std::max(std::abs(object.direction) - half_cone, 0.0);
    const double along = object.distance * std::cos(off);
    const double across = object.distance * std::sin(off);
    if (along <= 0.0 || across >= reach) continue;
    least = std::min(least, along - std::sqrt(reach * reach - across * across));
  }
  return std::max(least, 0.0);
}

}  // namespace latchwork::avoid
