// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_MAP_DISTANCE_MAP_H_
#define LATCHWORK_OMPL_MAP_DISTANCE_MAP_H_

#include <cstdint>
#include <vector>

#include "reasoners/ompl/map/grid.h"

namespace latchwork::planning {

/// How far each cell of a floor is from the nearest occupied one, exactly; what lies outside of the
/// grid is occupied. Source: Meijster, Roerdink and Hesselink, A general algorithm for computing
/// distance transforms in linear time (2000). Thread rule: const members from any thread.
class DistanceMap {
 public:
  explicit DistanceMap(const Grid& grid);

  int width() const { return width_; }
  int height() const { return height_; }
  double resolution() const { return resolution_; }
  double extent_x() const { return width_ * resolution_; }
  double extent_y() const { return height_ * resolution_; }

  int CellX(double x) const;
  int CellY(double y) const;
  Point CentreOf(int x, int y) const;
  bool IsInside(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  /// Squared, from centre to centre, in cells; 0 outside.
  std::int64_t SquaredCells(int x, int y) const {
    return IsInside(x, y) ? squared_[Index(x, y)] : 0;
  }
  /// No occupied cell is nearer than this to `place`, m; less than the distance itself by at most
  /// one and a half cells. Changes by no more than the place does.
  double Clearance(Point place) const;
  /// The largest that Clearance can be anywhere in the cell.
  double MostClearance(int x, int y) const;

 private:
  std::size_t Index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  double resolution_;
  std::vector<std::int32_t> squared_;
};

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_MAP_DISTANCE_MAP_H_
