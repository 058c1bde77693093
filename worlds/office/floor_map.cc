// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/floor_map.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cmath>
#include <limits>

namespace latchwork::office {

namespace {

constexpr float kFree = 0.98F;
constexpr float kOccupied = 0.02F;
constexpr float kThreshold = 0.5F;

}  // namespace

struct FloorMap::Grid {
  // The size must differ from the default's: MRPT keeps resolution and origin when cell counts
  // agree.
  Grid() : map(0.0F, 1.0F, 0.0F, 1.0F, 0.5F) {}
  mrpt::maps::COccupancyGridMap2D map;
};

FloorMap::FloorMap(const Cells& cells)
    : width_(cells.width),
      height_(cells.height),
      resolution_(cells.resolution),
      origin_(cells.origin),
      counts_(cells.occupied.size()),
      grid_(std::make_unique<Grid>()) {
  // Rays are cast in the map's own frame with unit cells: exact sizes whatever the origin and
  // resolution are.
  grid_->map.setSize(0.0F, static_cast<float>(width_), 0.0F, static_cast<float>(height_), 1.0F,
                     kFree);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (cells.occupied[IndexOf(x, y)] == 0) continue;
      counts_[IndexOf(x, y)] = kWall;
      grid_->map.setCell(x, y, kOccupied);
    }
  }
}

FloorMap::FloorMap(const FloorMap& other)
    : width_(other.width_),
      height_(other.height_),
      resolution_(other.resolution_),
      origin_(other.origin_),
      counts_(other.counts_),
      grid_(std::make_unique<Grid>(*other.grid_)) {}

FloorMap& FloorMap::operator=(const FloorMap& other) {
  if (this != &other) *this = FloorMap(other);
  return *this;
}

FloorMap::FloorMap(FloorMap&&) noexcept = default;
FloorMap& FloorMap::operator=(FloorMap&&) noexcept = default;
FloorMap::~FloorMap() = default;

int FloorMap::CellX(double x) const {
  return static_cast<int>(std::floor((x - origin_.x) / resolution_));
}

int FloorMap::CellY(double y) const {
  return static_cast<int>(std::floor((y - origin_.y) / resolution_));
}

void FloorMap::Cover(int cell_x, int cell_y) {
  if (!IsInside(cell_x, cell_y)) return;
  std::uint8_t& count = counts_[IndexOf(cell_x, cell_y)];
  if (count++ == 0) grid_->map.setCell(cell_x, cell_y, kOccupied);
}

void FloorMap::Uncover(int cell_x, int cell_y) {
  if (!IsInside(cell_x, cell_y)) return;
  std::uint8_t& count = counts_[IndexOf(cell_x, cell_y)];
  if (--count == 0) grid_->map.setCell(cell_x, cell_y, kFree);
}

double FloorMap::CastRay(Point from, double angle, double range) const {
  constexpr double kNothing = std::numeric_limits<double>::infinity();
  const double x = (from.x - origin_.x) / resolution_;
  const double y = (from.y - origin_.y) / resolution_;
  if (!(x >= 0.0 && y >= 0.0 && x < width_ && y < height_)) return kNothing;
  const double step = mrpt::maps::COccupancyGridMap2D::RAYTRACE_STEP_SIZE_IN_CELL_UNITS;
  const double cells = range / resolution_;
  float distance = 0.0F;
  bool valid = false;
  // The range argument bounds the number of steps, not the distance: two more steps cover its
  // rounding.
  grid_->map.simulateScanRay(x, y, angle, distance, valid, cells / step + 2.0, kThreshold);
  return valid && distance <= cells ? static_cast<double>(distance) * resolution_ : kNothing;
}

}  // namespace latchwork::office
