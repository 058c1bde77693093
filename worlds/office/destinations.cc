// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/destinations.h"

#include <cmath>
#include <utility>

#include "worlds/office/collision.h"

namespace latchwork::office {

namespace {

constexpr double kArrived = 0.6;     // m
constexpr double kPatience = 60.0;   // s
constexpr double kNearest = 2.0;     // m
constexpr double kFarthest = 15.0;   // m
constexpr double kClearance = 0.6;   // m
constexpr double kLattice = 0.2;     // m
constexpr double kMargin = 0.1;      // beyond the robot's rim on the way, m
constexpr std::size_t kPocket = 25;  // places; fewer are a corner that the margin cuts off

}  // namespace

Destinations::Destinations(std::uint64_t seed, double radius, double tick_seconds)
    : random_(seed, "destinations"),
      radius_(radius),
      patience_(static_cast<std::uint64_t>(std::lround(kPatience / tick_seconds))) {}

void Destinations::Update(const FloorMap& map, Point robot) {
  const bool arrived = current_ && Distance(*current_, robot) <= kArrived;
  if (arrived) ++reached_;
  if (version_ == 0 || arrived || ++waited_ >= patience_) Pick(map, robot);
}

void Destinations::Pick(const FloorMap& map, Point robot) {
  Explore(map, robot, radius_ + kMargin);
  if (reachable_.size() < kPocket) Explore(map, robot, radius_);
  std::erase_if(reachable_, [&](Point place) { return Distance(place, robot) < kNearest; });
  std::vector<Point> roomy;
  for (const Point place : reachable_) {
    if (!FindContact(map, place, kClearance)) roomy.push_back(place);
  }
  const std::vector<Point>& places = roomy.empty() ? reachable_ : roomy;
  ++version_;
  waited_ = 0;
  current_.reset();
  if (!places.empty()) current_ = places[random_.Index(places.size(), version_)];
}

/// Spreads over a lattice around the robot. Free discs a lattice step apart, larger than the robot
/// by the margin, leave the way between them free for it, so that way needs no check of its own.
void Destinations::Explore(const FloorMap& map, Point robot, double radius) {
  constexpr int kReach = static_cast<int>(kFarthest / kLattice);
  constexpr int kSide = 2 * kReach + 1;
  std::vector<char> seen(static_cast<std::size_t>(kSide) * kSide, 0);
  std::vector<std::pair<int, int>> open{{0, 0}};
  reachable_.clear();
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto [x, y] = open[i];
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const int nx = x + dx;
      const int ny = y + dy;
      if (nx * nx + ny * ny > kReach * kReach) continue;
      const int cell = (ny + kReach) * kSide + nx + kReach;
      char& mark = seen[static_cast<std::size_t>(cell)];
      if (mark != 0) continue;
      mark = 1;
      const Point place{robot.x + nx * kLattice, robot.y + ny * kLattice};
      if (FindContact(map, place, radius)) continue;
      open.emplace_back(nx, ny);
      reachable_.push_back(place);
    }
  }
}

}  // namespace latchwork::office
