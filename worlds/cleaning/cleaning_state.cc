// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cleaning/cleaning_state.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "worlds/cleaning/reach.h"

namespace latchwork::cleaning {

namespace {

constexpr std::size_t kMostSwept = 200000;

double Distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

std::array<Tile, 4> BoxAt(Tile corner) {
  return {corner, Tile{corner.i + 1, corner.j}, Tile{corner.i, corner.j + 1},
          Tile{corner.i + 1, corner.j + 1}};
}

/// Calls `visit` with the index of every floor tile whose middle is so near.
template <typename Visit>
void ForTilesNear(const FloorPlan& plan, Point place, double radius, const Visit& visit) {
  const Tile low = TileAt({place.x - radius, place.y - radius});
  const Tile high = TileAt({place.x + radius, place.y + radius});
  for (int j = std::max(low.j, 0); j <= std::min(high.j, plan.height() - 1); ++j) {
    for (int i = std::max(low.i, 0); i <= std::min(high.i, plan.width() - 1); ++i) {
      if (!plan.IsFloor({i, j}) || Distance(CentreOf({i, j}), place) > radius) continue;
      visit(plan.IndexOf({i, j}));
    }
  }
}

}  // namespace

void CleaningState::Begin(double heading, double robot_radius, double brush_radius) {
  radius = robot_radius;
  brush = brush_radius;
  const Point home = CentreOf(plan.dock());
  base.Place({home.x, home.y, heading});
  dirty.assign(plan.size(), 0);
  for (std::size_t tile = 0; tile < plan.size(); ++tile) {
    dirty[tile] = plan.IsFloor(plan.TileOf(tile)) ? 1 : 0;
  }
  in_reach = TilesInReach(plan, radius, brush);
  tiles_in_reach = static_cast<std::size_t>(std::count(in_reach.begin(), in_reach.end(), char{1}));
}

bool CleaningState::HasRoomForBox(Tile corner) const {
  const Point middle{(corner.i + 1) * kTile, (corner.j + 1) * kTile};
  const double clearance = 2 * kTile + radius;
  if (Distance(middle, CentreOf(plan.dock())) < 2 * clearance) return false;
  if (Distance(middle, base.place()) < clearance) return false;
  const auto tiles = BoxAt(corner);
  return std::all_of(tiles.begin(), tiles.end(), [&](Tile tile) { return plan.IsFloor(tile); });
}

void CleaningState::PutBox(Tile corner) {
  for (const Tile tile : BoxAt(corner)) {
    plan.Put(tile, Surface::kBox);
    dirty[plan.IndexOf(tile)] = 0;
  }
  in_reach = TilesInReach(plan, radius, brush);
  tiles_in_reach = static_cast<std::size_t>(std::count(in_reach.begin(), in_reach.end(), char{1}));
}

void CleaningState::Sweep(double seconds) {
  ForTilesNear(plan, base.place(), brush, [&](std::size_t tile) {
    if (dirty[tile] == 0) return;
    dirty[tile] = 0;
    if (swept.size() < kMostSwept) swept.push_back({seconds, tile});
  });
}

void CleaningState::Spill(Point place, double spill_radius) {
  ForTilesNear(plan, place, spill_radius, [&](std::size_t tile) { dirty[tile] = 1; });
}

bool CleaningState::IsDocked() const {
  return Distance(base.place(), CentreOf(plan.dock())) <= kDockRadius;
}

double CleaningState::CleanPart() const {
  std::size_t clean = 0;
  for (std::size_t tile = 0; tile < dirty.size(); ++tile) {
    if (in_reach[tile] != 0 && dirty[tile] == 0) ++clean;
  }
  return tiles_in_reach == 0 ? 1.0
                             : static_cast<double>(clean) / static_cast<double>(tiles_in_reach);
}

}  // namespace latchwork::cleaning
