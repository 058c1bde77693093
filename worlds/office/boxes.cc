// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/boxes.h"

#include <algorithm>

#include "latchwork/sdk/random.h"
#include "worlds/office/collision.h"

namespace latchwork::office {

namespace {

constexpr int kTriesPerBox = 200;
constexpr double kPassage = 0.45;
constexpr double kBareMargin = 0.95;
constexpr double kFromRobot = 1.5;

Rect Grown(const Rect& r, double by) { return {r.x1 - by, r.y1 - by, r.x2 + by, r.y2 + by}; }

bool IsFree(const FloorMap& map, const Rect& area) {
  const auto cells = CellsOf(map, area);
  return std::none_of(cells.begin(), cells.end(),
                      [&](CellIndex cell) { return map.IsOccupied(cell.x, cell.y); });
}

/// The nearest that points of a segment come to a rectangle, to a centimetre.
double Distance(const Segment& line, const Rect& area) {
  const int steps = 1 + static_cast<int>(Distance(line.a, line.b) / 0.02);
  double nearest = Distance(line.a, area);
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    nearest = std::min(nearest, Distance(Point{line.a.x + t * (line.b.x - line.a.x),
                                               line.a.y + t * (line.b.y - line.a.y)},
                                         area));
  }
  return nearest;
}

bool KeepsWaysOpen(const Building& building, const Box& box) {
  for (const Edge& edge : building.edges) {
    const Landmark& a = building.landmarks[edge.a];
    if (a.floor != box.floor) continue;
    if (Distance({a.place, building.landmarks[edge.b].place}, box.area) < kPassage + 0.01) {
      return false;
    }
  }
  for (const Door& door : building.doors) {
    if (door.floor == box.floor && Distance(door.leaf, box.area) < 1.0) return false;
  }
  return std::none_of(building.elevators.begin(), building.elevators.end(), [&](const auto& shaft) {
    return Distance(shaft.door, box.area) < 1.5 || Distance(shaft.cab.centre(), box.area) < 1.5;
  });
}

bool IsGoodPlace(const Building& building, const std::vector<Box>& boxes, const Box& box) {
  const FloorMap& map = building.floors[static_cast<std::size_t>(box.floor)].map;
  const bool bare = building.edges.empty();
  if (!IsFree(map, bare ? Grown(box.area, kBareMargin) : box.area)) return false;
  for (const Box& other : boxes) {
    const Rect near = Grown(other.area, kBareMargin);
    if (other.floor == box.floor && box.area.x1 < near.x2 && box.area.x2 > near.x1 &&
        box.area.y1 < near.y2 && box.area.y2 > near.y1) {
      return false;
    }
  }
  return bare || KeepsWaysOpen(building, box);
}

Box Draw(const Building& building, const sdk::RandomStream& random, std::uint64_t number,
         std::uint64_t attempt) {
  const std::uint64_t b = attempt * 8;
  Box box;
  box.floor = static_cast<int>(random.Index(building.floors.size(), number, b));
  const FloorMap& map = building.floors[static_cast<std::size_t>(box.floor)].map;
  const double x = map.origin().x + map.width() * map.resolution() * random.Uniform(number, b + 1);
  const double y = map.origin().y + map.height() * map.resolution() * random.Uniform(number, b + 2);
  box.area = {x, y, x + random.Between(0.3, 0.6, number, b + 3),
              y + random.Between(0.3, 0.6, number, b + 4)};
  return box;
}

}  // namespace

std::vector<Box> PlaceBoxes(const Building& building, int count, std::uint64_t seed, int floor,
                            Point keep_free) {
  const sdk::RandomStream random(seed, "boxes");
  std::vector<Box> boxes;
  for (int number = 0; number < count; ++number) {
    for (std::uint64_t attempt = 0; attempt < kTriesPerBox; ++attempt) {
      const Box box = Draw(building, random, static_cast<std::uint64_t>(number), attempt);
      if (box.floor == floor && Distance(keep_free, box.area) < kFromRobot) continue;
      if (!IsGoodPlace(building, boxes, box)) continue;
      boxes.push_back(box);
      break;
    }
  }
  return boxes;
}

}  // namespace latchwork::office
