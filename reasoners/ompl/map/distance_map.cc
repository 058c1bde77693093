// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/map/distance_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace latchwork::planning {
namespace {

constexpr double kHalfDiagonal = std::numbers::sqrt2 / 2.0;  // of a cell, in cells

/// In each column: how many cells up or down to the nearest occupied one or to the rim.
std::vector<std::int32_t> ColumnDistances(const Grid& grid) {
  std::vector<std::int32_t> distance(grid.occupied.size());
  for (int x = 0; x < grid.width; ++x) {
    std::int32_t run = 0;
    for (int y = 0; y < grid.height; ++y) {
      run = grid.occupied[grid.Index(x, y)] != 0 ? 0 : run + 1;
      distance[grid.Index(x, y)] = run;
    }
    run = 0;
    for (int y = grid.height; y-- > 0;) {
      run = grid.occupied[grid.Index(x, y)] != 0 ? 0 : run + 1;
      distance[grid.Index(x, y)] = std::min(distance[grid.Index(x, y)], run);
    }
  }
  return distance;
}

/// One row of the second phase: the lower envelope of the parabolas of its columns. The row has a
/// cell more at either end, for the rim.
class Envelope {
 public:
  explicit Envelope(int width)
      : column_(static_cast<std::size_t>(width) + 2),
        apex_(column_.size()),
        from_(column_.size()) {}

  void Squares(const std::int32_t* column, std::int32_t* squares) {
    const auto last = static_cast<std::int64_t>(column_.size()) - 1;
    for (std::int64_t x = 1; x < last; ++x) At(column_, x) = column[x - 1];
    std::int64_t top = 0;
    apex_[0] = from_[0] = 0;
    for (std::int64_t x = 1; x <= last; ++x) {
      while (top >= 0 && Value(At(from_, top), At(apex_, top)) > Value(At(from_, top), x)) --top;
      const std::int64_t begin = top < 0 ? 0 : 1 + Separation(At(apex_, top), x);
      if (begin > last) continue;
      ++top;
      At(apex_, top) = x;
      At(from_, top) = begin;
    }
    for (std::int64_t x = last; x >= 0; --x) {
      if (x > 0 && x < last) {
        squares[x - 1] = static_cast<std::int32_t>(Value(x, At(apex_, top)));
      }
      if (x == At(from_, top)) --top;
    }
  }

 private:
  static std::int64_t& At(std::vector<std::int64_t>& values, std::int64_t index) {
    return values[static_cast<std::size_t>(index)];
  }
  std::int64_t Value(std::int64_t x, std::int64_t apex) {
    return (x - apex) * (x - apex) + At(column_, apex) * At(column_, apex);
  }
  /// The last cell at which the parabola of `a` is not above that of `b`; a < b.
  std::int64_t Separation(std::int64_t a, std::int64_t b) {
    return (b * b - a * a + At(column_, b) * At(column_, b) - At(column_, a) * At(column_, a)) /
           (2 * (b - a));
  }

  std::vector<std::int64_t> column_;
  std::vector<std::int64_t> apex_;
  std::vector<std::int64_t> from_;
};

}  // namespace

DistanceMap::DistanceMap(const Grid& grid)
    : width_(grid.width),
      height_(grid.height),
      resolution_(grid.resolution),
      squared_(ColumnDistances(grid)) {
  Envelope envelope(width_);
  std::vector<std::int32_t> row(static_cast<std::size_t>(width_));
  for (int y = 0; y < height_; ++y) {
    envelope.Squares(&squared_[Index(0, y)], row.data());
    std::copy(row.begin(), row.end(), squared_.begin() + static_cast<std::ptrdiff_t>(Index(0, y)));
  }
}

int DistanceMap::CellX(double x) const {
  return static_cast<int>(std::floor(std::clamp(x / resolution_, -1.0, width_ + 1.0)));
}

int DistanceMap::CellY(double y) const {
  return static_cast<int>(std::floor(std::clamp(y / resolution_, -1.0, height_ + 1.0)));
}

Point DistanceMap::CentreOf(int x, int y) const {
  return {(x + 0.5) * resolution_, (y + 0.5) * resolution_};
}

double DistanceMap::Clearance(Point place) const {
  const int x = CellX(place.x);
  const int y = CellY(place.y);
  if (!IsInside(x, y)) return 0.0;
  return std::max(0.0, MostClearance(x, y) - Distance(place, CentreOf(x, y)));
}

double DistanceMap::MostClearance(int x, int y) const {
  const double cells = std::sqrt(static_cast<double>(SquaredCells(x, y)));
  return std::max(0.0, (cells - kHalfDiagonal) * resolution_);
}

}  // namespace latchwork::planning
