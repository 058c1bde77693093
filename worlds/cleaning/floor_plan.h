// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CLEANING_FLOOR_PLAN_H_
#define LATCHWORK_CLEANING_FLOOR_PLAN_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::cleaning {

/// Side of a tile, m.
inline constexpr double kTile = 0.25;

/// Metres; x to the east, y to the north, the origin in the south-west corner of the plan.
struct Point {
  double x = 0;
  double y = 0;
};

/// Column from the west, row from the south.
struct Tile {
  int i = 0;
  int j = 0;
  friend bool operator==(const Tile&, const Tile&) = default;
};

inline Point CentreOf(Tile tile) { return {(tile.i + 0.5) * kTile, (tile.j + 0.5) * kTile}; }
Tile TileAt(Point place);

enum class Surface : std::uint8_t { kFloor, kWall, kFurniture, kBox };

/// A floor of tiles: what stands on each, and where the robot's dock is. What lies outside is wall.
class FloorPlan {
 public:
  FloorPlan() = default;
  FloorPlan(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return surfaces_.size(); }
  std::size_t IndexOf(Tile tile) const {
    return static_cast<std::size_t>(tile.j) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(tile.i);
  }
  Tile TileOf(std::size_t index) const {
    return {static_cast<int>(index) % width_, static_cast<int>(index) / width_};
  }
  bool Contains(Tile tile) const {
    return tile.i >= 0 && tile.j >= 0 && tile.i < width_ && tile.j < height_;
  }
  Surface At(Tile tile) const { return Contains(tile) ? surfaces_[IndexOf(tile)] : Surface::kWall; }
  bool IsFloor(Tile tile) const { return At(tile) == Surface::kFloor; }
  void Put(Tile tile, Surface surface) { surfaces_[IndexOf(tile)] = surface; }

  Tile dock() const { return dock_; }
  void set_dock(Tile dock) { dock_ = dock; }

  /// Whether a disc overlaps a tile that is no floor.
  bool Touches(Point centre, double radius) const;
  /// Way from a place in a direction to the first tile that is no floor, at most `limit`.
  double FreeWay(Point from, double direction, double limit) const;
  /// Whether the straight line between two places crosses floor only.
  bool Sees(Point from, Point to) const;

 private:
  int width_ = 0;
  int height_ = 0;
  Tile dock_;
  std::vector<Surface> surfaces_;
};

/// The plan that a text draws, a character for a tile, the northern row first: `#` wall, `o`
/// furniture, `.` floor, `D` the dock, which is floor too. Lines that begin with `;` are comments.
/// Everything wrong with it becomes diagnostics, with its place in `file`.
FloorPlan ReadFloorPlan(std::string_view text, const std::string& file,
                        logic::Diagnostics& diagnostics);

}  // namespace latchwork::cleaning

#endif  // LATCHWORK_CLEANING_FLOOR_PLAN_H_
