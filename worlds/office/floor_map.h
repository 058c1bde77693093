// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_FLOOR_MAP_H_
#define LATCHWORK_OFFICE_FLOOR_MAP_H_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "worlds/office/geometry.h"

namespace latchwork::office {

/// The cells of a map file before they become a floor: 1 = occupied or unknown, row by row from the
/// south.
struct Cells {
  int width = 0;
  int height = 0;
  double resolution = 0.0;  ///< m per cell
  Point origin;             ///< Lower left corner, m.
  std::vector<std::uint8_t> occupied;
};

/// One storey: an MRPT occupancy grid, and above it what comes and goes in a run (shut doors,
/// boxes). Unknown cells and everything outside count as occupied, for collisions and for sonar
/// alike: what the robot may not touch, it can sense. A value: a copy shares nothing. Thread rule:
/// const members may be called from any thread.
class FloorMap {
 public:
  explicit FloorMap(const Cells& cells);
  FloorMap(const FloorMap& other);
  FloorMap& operator=(const FloorMap& other);
  FloorMap(FloorMap&&) noexcept;
  FloorMap& operator=(FloorMap&&) noexcept;
  ~FloorMap();

  int width() const { return width_; }
  int height() const { return height_; }
  double resolution() const { return resolution_; }
  Point origin() const { return origin_; }

  int CellX(double x) const;
  int CellY(double y) const;
  bool IsOccupied(int cell_x, int cell_y) const {
    return !IsInside(cell_x, cell_y) || Count(cell_x, cell_y) != 0;
  }
  /// Occupied in the map itself, without what was covered.
  bool IsWall(int cell_x, int cell_y) const {
    return !IsInside(cell_x, cell_y) || (Count(cell_x, cell_y) & kWall) != 0;
  }
  /// Puts something on a cell; covers of one cell add up and each needs its own Uncover. Outside:
  /// ignored.
  void Cover(int cell_x, int cell_y);
  void Uncover(int cell_x, int cell_y);

  /// Distance to the first occupied cell along a ray, by MRPT's simulateScanRay; infinity when
  /// nothing stands within `range` metres. Never short; up to two ray steps (0.8 cells each) long.
  double CastRay(Point from, double angle, double range) const;

 private:
  static constexpr std::uint8_t kWall = 0x80;
  struct Grid;

  bool IsInside(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  std::size_t IndexOf(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  std::uint8_t Count(int x, int y) const { return counts_[IndexOf(x, y)]; }

  int width_;
  int height_;
  double resolution_;
  Point origin_;
  std::vector<std::uint8_t> counts_;
  std::unique_ptr<Grid> grid_;
};

/// Either cells, or what is wrong in one sentence.
struct LoadedCells {
  std::optional<Cells> cells;
  std::string error;
};

/// Reads a map by its suffix: .png or .pgm (at `resolution` m per pixel, darker than mid-grey
/// occupied), ROS map_server .yaml, MRPT .gridmap[.gz] and .simplemap[.gz]. Files that are
/// truncated, huge or no maps are refused with a message.
LoadedCells LoadCells(const std::filesystem::path& file, double resolution);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_FLOOR_MAP_H_
