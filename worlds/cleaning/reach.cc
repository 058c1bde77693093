// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cleaning/reach.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace latchwork::cleaning {

namespace {

constexpr int kStepsPerTile = 5;
constexpr double kStep = kTile / kStepsPerTile;

/// The places of a grid finer than that of the tiles; the middle of each tile is one of them.
class Places {
 public:
  Places(const FloorPlan& plan, double radius)
      : plan_(plan),
        radius_(radius),
        width_(plan.width() * kStepsPerTile),
        height_(plan.height() * kStepsPerTile),
        met_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0) {}

  /// Calls `visit` with every place that the disc can be moved to.
  template <typename Visit>
  void FloodFrom(Tile tile, const Visit& visit) {
    Meet(tile.i * kStepsPerTile + kStepsPerTile / 2, tile.j * kStepsPerTile + kStepsPerTile / 2);
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      const auto [x, y] = queue_[next];
      visit(Middle(x, y));
      Meet(x + 1, y);
      Meet(x - 1, y);
      Meet(x, y + 1);
      Meet(x, y - 1);
    }
  }

 private:
  static Point Middle(int x, int y) { return {(x + 0.5) * kStep, (y + 0.5) * kStep}; }

  void Meet(int x, int y) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(x);
    if (met_[index] != 0) return;
    met_[index] = 1;
    if (!plan_.Touches(Middle(x, y), radius_)) queue_.push_back({x, y});
  }

  const FloorPlan& plan_;
  double radius_;
  int width_;
  int height_;
  std::vector<char> met_;
  std::vector<std::array<int, 2>> queue_;
};

}  // namespace

std::vector<char> TilesInReach(const FloorPlan& plan, double radius, double brush) {
  std::vector<char> reached(plan.size(), 0);
  const int far = static_cast<int>(brush / kTile) + 1;
  Places(plan, radius).FloodFrom(plan.dock(), [&](Point place) {
    const Tile middle = TileAt(place);
    for (int j = middle.j - far; j <= middle.j + far; ++j) {
      for (int i = middle.i - far; i <= middle.i + far; ++i) {
        const Tile tile{i, j};
        if (!plan.IsFloor(tile) || reached[plan.IndexOf(tile)] != 0) continue;
        const Point centre = CentreOf(tile);
        if (std::hypot(centre.x - place.x, centre.y - place.y) <= brush) {
          reached[plan.IndexOf(tile)] = 1;
        }
      }
    }
  });
  return reached;
}

}  // namespace latchwork::cleaning
