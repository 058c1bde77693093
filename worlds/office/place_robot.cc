// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "worlds/office/making.h"

namespace latchwork::office {

namespace {

constexpr int kPlaceTries = 20000;

bool IsRoomy(const FloorMap& map, Point from, double radius) {
  constexpr double kStep = 0.25;
  constexpr std::size_t kEnough = 160;  // steps of a quarter metre: ten square metres
  std::queue<std::pair<int, int>> open;
  std::vector<std::pair<int, int>> seen{{0, 0}};
  open.emplace(0, 0);
  while (!open.empty() && seen.size() < kEnough) {
    const auto [x, y] = open.front();
    open.pop();
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const std::pair next{x + dx, y + dy};
      if (std::find(seen.begin(), seen.end(), next) != seen.end()) continue;
      const Point a{from.x + x * kStep, from.y + y * kStep};
      const Point b{from.x + next.first * kStep, from.y + next.second * kStep};
      if (!IsLineFree(map, a, b, radius)) continue;
      seen.push_back(next);
      open.push(next);
    }
  }
  return seen.size() >= kEnough;
}

/// On a bare map: a place with some room around it, in a region that is more than a pocket.
Pose AnyFreePlace(Making& making) {
  const FloorMap& map = making.state.map();
  for (std::uint64_t i = 0; i < kPlaceTries; ++i) {
    const Point place{
        map.origin().x + map.width() * map.resolution() * making.random.Uniform(5, 2 * i),
        map.origin().y + map.height() * map.resolution() * making.random.Uniform(5, 2 * i + 1)};
    if (FindContact(map, place, making.state.radius + 0.25)) continue;
    if (IsRoomy(map, place, making.state.radius)) return {place.x, place.y, 0.0};
  }
  making.Fail("map", "the map has no free place for the robot");
  return {};
}

Pose NearLandmark(Making& making, std::size_t index) {
  const Landmark& landmark = making.building().landmarks[index];
  making.state.floor = landmark.floor;
  const double spread = making.parameters.Real("start_spread");
  for (std::uint64_t i = 0; spread > 0.0 && i < 200; ++i) {
    const double way = spread * std::sqrt(making.random.Uniform(3, 2 * i));
    const double angle = making.random.Between(-std::numbers::pi, std::numbers::pi, 3, 2 * i + 1);
    const Point place{landmark.place.x + way * std::cos(angle),
                      landmark.place.y + way * std::sin(angle)};
    if (IsLineFree(making.state.map(), landmark.place, place, making.state.radius + 0.15)) {
      return {place.x, place.y, 0.0};
    }
  }
  return {landmark.place.x, landmark.place.y, 0.0};
}

Pose AnyRoom(Making& making) {
  const auto floor =
      making.building().FindFloor(static_cast<int>(making.parameters.Integer("start_floor")));
  std::vector<std::size_t> landmarks;
  for (const Room& room : making.building().rooms) {
    const auto landmark = making.building().FindLandmark(room.name.name());
    if (landmark && (!floor || room.floor == *floor)) landmarks.push_back(*landmark);
  }
  if (landmarks.empty()) return AnyFreePlace(making);
  return NearLandmark(making, landmarks[making.random.Index(landmarks.size(), 4)]);
}

Pose StartPlace(Making& making) {
  const std::string& name = making.parameters.Text("start");
  if (name == "pose") {
    const auto number = making.parameters.Integer("start_floor");
    const auto floor =
        number == 0 ? std::optional(0) : making.building().FindFloor(static_cast<int>(number));
    if (!floor) making.Fail("start_floor", "the building has no floor " + std::to_string(number));
    making.state.floor = floor.value_or(0);
    return {making.parameters.Real("start_x"), making.parameters.Real("start_y"), 0.0};
  }
  if (!name.empty()) {
    const auto landmark = making.building().FindLandmark(name);
    if (landmark && making.building().landmarks[*landmark].floor >= 0) {
      return NearLandmark(making, *landmark);
    }
    making.FailName("start", "landmark", name, NamesOf(making.building().landmarks));
    return {};
  }
  return making.building().rooms.empty() ? AnyFreePlace(making) : AnyRoom(making);
}

double StartHeading(Making& making) {
  const std::string& text = making.parameters.Text("start_heading");
  if (text.empty()) return making.random.Between(-std::numbers::pi, std::numbers::pi, 2, 0);
  const auto heading = Number(text);
  if (!heading) making.Fail("start_heading", "'" + text + "' is not a number of radians");
  return heading.value_or(0.0);
}

}  // namespace

void PlaceRobot(Making& making) {
  VehicleOptions options;
  options.max_speed = making.parameters.Real("max_speed");
  making.state.radius = options.radius;
  making.state.vehicle.emplace(options, making.setup.tick_seconds);
  Pose pose = StartPlace(making);
  pose.heading = StartHeading(making);
  const auto& map = making.state.map();
  if (making.diagnostics.empty() && FindContact(map, PointOf(pose), options.radius)) {
    making.Fail("start", "the robot has no room at its start");
  }
  making.state.vehicle->Place(pose);
}

}  // namespace latchwork::office
