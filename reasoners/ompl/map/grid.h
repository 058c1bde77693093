// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_MAP_GRID_H_
#define LATCHWORK_OMPL_MAP_GRID_H_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace latchwork::planning {

/// In the building's frame, m.
struct Point {
  double x = 0.0;
  double y = 0.0;
  friend bool operator==(const Point&, const Point&) = default;
};

double Distance(Point a, Point b);
/// The point that lies the fraction `t` of the way from `a` to `b`.
Point Between(Point a, Point b, double t);

/// The cells of a floor, row by row from the south: 1 = occupied. Its lower left corner is the
/// origin of the frame.
struct Grid {
  int width = 0;
  int height = 0;
  double resolution = 0.05;  ///< m per cell
  std::vector<std::uint8_t> occupied;

  std::size_t Index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

struct ReadGrid {
  std::optional<Grid> grid;
  std::string error;  ///< When there is no grid: why.
};

/// A PNG picture: what is darker than middle grey is occupied.
ReadGrid ReadPng(const std::filesystem::path& file, double resolution);

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_MAP_GRID_H_
