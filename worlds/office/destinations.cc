// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/destinations.h"

#include <cmath>
#include <numbers>

#include "worlds/office/collision.h"

namespace latchwork::office {
namespace {

constexpr double kReached = 0.45;   // m
constexpr double kPatience = 60.0;  // s
constexpr double kNearest = 1.0;    // m
constexpr double kFarthest = 10.0;  // m
constexpr double kRoom = 0.2;       // m, beside the robot on the straight way
constexpr std::uint64_t kTries = 200;

}  // namespace

Destinations::Destinations(std::uint64_t seed, double radius, double tick_seconds)
    : random_(seed, "destinations"),
      radius_(radius),
      patience_(static_cast<std::uint64_t>(kPatience / tick_seconds)) {}

Point Destinations::At(std::uint64_t tick, const FloorMap& map, Point robot) {
  if (chosen_ && Distance(place_, robot) > kReached && tick - since_ < patience_) return place_;
  place_ = Choose(tick, map, robot);
  since_ = tick;
  chosen_ = true;
  return place_;
}

Point Destinations::Choose(std::uint64_t tick, const FloorMap& map, Point robot) const {
  for (std::uint64_t i = 0; i < kTries; ++i) {
    // In a tight place the first half of the tries may find nothing; then any free way will do.
    const double room = i < kTries / 2 ? kRoom : 0.01;
    const double way = random_.Between(kNearest, kFarthest, tick, 2 * i);
    const double angle = random_.Between(-std::numbers::pi, std::numbers::pi, tick, 2 * i + 1);
    const Point place{robot.x + way * std::cos(angle), robot.y + way * std::sin(angle)};
    if (IsLineFree(map, robot, place, radius_ + room)) return place;
  }
  return robot;
}

}  // namespace latchwork::office
