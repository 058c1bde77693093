// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cleaning/floor_plan.h"

#include <algorithm>
#include <cmath>

namespace latchwork::cleaning {

namespace {

/// From a place to the nearest point of a tile.
double DistanceTo(Tile tile, Point p) {
  const double dx = std::max({tile.i * kTile - p.x, 0.0, p.x - (tile.i + 1) * kTile});
  const double dy = std::max({tile.j * kTile - p.y, 0.0, p.y - (tile.j + 1) * kTile});
  return std::hypot(dx, dy);
}

/// Where a ray next crosses a line between tiles along one axis.
struct Crossing {
  double at = 0;    ///< Way along the ray.
  double step = 0;  ///< To the next one.
  int turn = 0;     ///< How the tile's number changes.
};

Crossing FirstCrossing(double place, int tile, double slope) {
  if (slope == 0.0) return {INFINITY, INFINITY, 0};
  const double line = (slope > 0 ? tile + 1 : tile) * kTile;
  return {(line - place) / slope, kTile / std::abs(slope), slope > 0 ? 1 : -1};
}

}  // namespace

Tile TileAt(Point place) {
  return {static_cast<int>(std::floor(place.x / kTile)),
          static_cast<int>(std::floor(place.y / kTile))};
}

FloorPlan::FloorPlan(int width, int height)
    : width_(width),
      height_(height),
      surfaces_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                Surface::kFloor) {}

bool FloorPlan::Touches(Point centre, double radius) const {
  const Tile low = TileAt({centre.x - radius, centre.y - radius});
  const Tile high = TileAt({centre.x + radius, centre.y + radius});
  for (int j = low.j; j <= high.j; ++j) {
    for (int i = low.i; i <= high.i; ++i) {
      if (!IsFloor({i, j}) && DistanceTo({i, j}, centre) < radius) return true;
    }
  }
  return false;
}

double FloorPlan::FreeWay(Point from, double direction, double limit) const {
  Tile tile = TileAt(from);
  Crossing x = FirstCrossing(from.x, tile.i, std::cos(direction));
  Crossing y = FirstCrossing(from.y, tile.j, std::sin(direction));
  double way = 0.0;
  while (way < limit && IsFloor(tile)) {
    const bool along_x = x.at < y.at;
    Crossing& next = along_x ? x : y;
    (along_x ? tile.i : tile.j) += next.turn;
    way = next.at;
    next.at += next.step;
  }
  return std::min(way, limit);
}

bool FloorPlan::Sees(Point from, Point to) const {
  const double distance = std::hypot(to.x - from.x, to.y - from.y);
  return FreeWay(from, std::atan2(to.y - from.y, to.x - from.x), distance) >= distance;
}

namespace {

std::vector<std::pair<std::size_t, std::string_view>> LinesOf(std::string_view text) {
  std::vector<std::pair<std::size_t, std::string_view>> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!line.empty() && line.front() != ';') lines.emplace_back(number, line);
  }
  return lines;
}

constexpr std::size_t kLargest = 400;  // tiles to a side

/// Reads the rows of a plan, and collects what is wrong with them.
class PlanReader {
 public:
  PlanReader(const std::string& file, logic::Diagnostics& diagnostics)
      : file_(file), diagnostics_(diagnostics) {}

  FloorPlan Read(std::string_view text) {
    const auto lines = LinesOf(text);
    const std::size_t width = lines.empty() ? 0 : lines.front().second.size();
    if (lines.size() < 3 || width < 3 || lines.size() > kLargest || width > kLargest) {
      Say(1, 1, "a plan has 3 to 400 rows of 3 to 400 tiles");
      return {};
    }
    FloorPlan plan(static_cast<int>(width), static_cast<int>(lines.size()));
    for (std::size_t row = 0; row < lines.size(); ++row) {
      const auto& [number, line] = lines[row];
      if (line.size() != width) Say(number, 1, "this row is not as long as the first");
      ReadRow(line.substr(0, width), number, static_cast<int>(lines.size() - 1 - row), plan);
    }
    if (docks_ != 1) Say(1, 1, "a plan has one dock, 'D'; this one has " + std::to_string(docks_));
    return plan;
  }

 private:
  void ReadRow(std::string_view line, std::size_t number, int j, FloorPlan& plan) {
    for (std::size_t column = 0; column < line.size(); ++column) {
      const Tile tile{static_cast<int>(column), j};
      switch (line[column]) {
        case '#':
          plan.Put(tile, Surface::kWall);
          break;
        case 'o':
          plan.Put(tile, Surface::kFurniture);
          break;
        case 'D':
          plan.set_dock(tile);
          ++docks_;
          break;
        case '.':
          break;
        default:
          Say(number, column + 1, "a tile is one of # o . D");
      }
    }
  }

  void Say(std::size_t line, std::size_t column, std::string message) {
    diagnostics_.push_back(
        {{file_, static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(column)},
         std::move(message),
         {},
         {}});
  }

  const std::string& file_;
  logic::Diagnostics& diagnostics_;
  int docks_ = 0;
};

}  // namespace

FloorPlan ReadFloorPlan(std::string_view text, const std::string& file,
                        logic::Diagnostics& diagnostics) {
  return PlanReader(file, diagnostics).Read(text);
}

}  // namespace latchwork::cleaning
