// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/collision.h"

#include <algorithm>
#include <cmath>

namespace latchwork::office {

std::optional<CellIndex> FindContact(const FloorMap& map, Point centre, double radius) {
  const double size = map.resolution();
  // In the frame of the map, in metres.
  const double x = centre.x - map.origin().x;
  const double y = centre.y - map.origin().y;
  double nearest = radius * radius;
  std::optional<CellIndex> contact;
  const int x_end = map.CellX(centre.x + radius);
  const int y_end = map.CellY(centre.y + radius);
  for (int cy = map.CellY(centre.y - radius); cy <= y_end; ++cy) {
    const double dy = std::max({cy * size - y, 0.0, y - (cy + 1) * size});
    if (dy * dy >= nearest) continue;
    for (int cx = map.CellX(centre.x - radius); cx <= x_end; ++cx) {
      if (!map.IsOccupied(cx, cy)) continue;
      const double dx = std::max({cx * size - x, 0.0, x - (cx + 1) * size});
      const double squared = dx * dx + dy * dy;
      if (squared >= nearest) continue;
      nearest = squared;
      contact = CellIndex{cx, cy};
    }
  }
  return contact;
}

bool IsLineFree(const FloorMap& map, Point a, Point b, double radius) {
  const double step = map.resolution() / 2.0;
  const int steps = std::max(1, static_cast<int>(std::ceil(Distance(a, b) / step)));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    if (FindContact(map, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, radius)) return false;
  }
  return true;
}

std::vector<CellIndex> CellsOf(const FloorMap& map, const Rect& rect) {
  constexpr double kHair = 1e-6;  // an edge on a cell's border does not take the next cell
  std::vector<CellIndex> cells;
  for (int y = map.CellY(rect.y1 + kHair); y <= map.CellY(rect.y2 - kHair); ++y) {
    for (int x = map.CellX(rect.x1 + kHair); x <= map.CellX(rect.x2 - kHair); ++x) {
      cells.push_back({x, y});
    }
  }
  return cells;
}

std::vector<CellIndex> CellsOf(const FloorMap& map, const Segment& leaf, double thickness) {
  const double half = thickness / 2.0;
  const double size = map.resolution();
  const Rect reach{std::min(leaf.a.x, leaf.b.x) - half, std::min(leaf.a.y, leaf.b.y) - half,
                   std::max(leaf.a.x, leaf.b.x) + half, std::max(leaf.a.y, leaf.b.y) + half};
  std::vector<CellIndex> cells = CellsOf(map, reach);
  std::erase_if(cells, [&](CellIndex cell) {
    const Point middle{map.origin().x + (cell.x + 0.5) * size,
                       map.origin().y + (cell.y + 0.5) * size};
    return Distance(middle, leaf) > half + 1e-9;
  });
  return cells;
}

void Cover(FloorMap& map, const std::vector<CellIndex>& cells) {
  for (const CellIndex cell : cells) map.Cover(cell.x, cell.y);
}

void Uncover(FloorMap& map, const std::vector<CellIndex>& cells) {
  for (const CellIndex cell : cells) map.Uncover(cell.x, cell.y);
}

}  // namespace latchwork::office
