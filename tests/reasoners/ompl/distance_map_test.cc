// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/map/distance_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latchwork/sdk/random.h"

namespace latchwork::planning {
namespace {

Grid RandomGrid(std::uint64_t number, double density) {
  const sdk::RandomStream random(7, "grids");
  Grid grid{static_cast<int>(2 + random.Index(30, number, 0)),
            static_cast<int>(2 + random.Index(30, number, 1)),
            0.1,
            {}};
  for (int i = 0; i < grid.width * grid.height; ++i) {
    const bool occupied = random.Uniform(number, 2 + static_cast<std::uint64_t>(i)) < density;
    grid.occupied.push_back(occupied ? 1 : 0);
  }
  return grid;
}

/// Over every cell, and the rim around them.
std::int64_t NearestByHand(const Grid& grid, int x, int y) {
  std::int64_t least = 1'000'000;
  for (int v = -1; v <= grid.height; ++v) {
    for (int u = -1; u <= grid.width; ++u) {
      const bool inside = u >= 0 && v >= 0 && u < grid.width && v < grid.height;
      if (inside && grid.occupied[grid.Index(u, v)] == 0) continue;
      least = std::min<std::int64_t>(least, (u - x) * (u - x) + (v - y) * (v - y));
    }
  }
  return least;
}

/// From a place to the squares of the occupied cells.
double DistanceByHand(const Grid& grid, Point place) {
  double least = 1e9;
  for (int v = -1; v <= grid.height; ++v) {
    for (int u = -1; u <= grid.width; ++u) {
      const bool inside = u >= 0 && v >= 0 && u < grid.width && v < grid.height;
      if (inside && grid.occupied[grid.Index(u, v)] == 0) continue;
      const double dx = std::max({u * 0.1 - place.x, 0.0, place.x - (u + 1) * 0.1});
      const double dy = std::max({v * 0.1 - place.y, 0.0, place.y - (v + 1) * 0.1});
      least = std::min(least, std::hypot(dx, dy));
    }
  }
  return least;
}

TEST(DistanceMapTest, RandomGrids_AsByHand) {
  for (std::uint64_t number = 0; number < 200; ++number) {
    const Grid grid = RandomGrid(number, number % 4 == 0 ? 0.3 : 0.01);
    const DistanceMap map(grid);
    for (int y = 0; y < grid.height; ++y) {
      for (int x = 0; x < grid.width; ++x) {
        ASSERT_EQ(map.SquaredCells(x, y), NearestByHand(grid, x, y))
            << "grid " << number << " at " << x << ", " << y;
      }
    }
  }
}

TEST(DistanceMapTest, Clearance_NeverMoreThanThereIs) {
  const sdk::RandomStream random(8, "places");
  for (std::uint64_t number = 0; number < 40; ++number) {
    const Grid grid = RandomGrid(number, 0.02);
    const DistanceMap map(grid);
    for (std::uint64_t i = 0; i < 50; ++i) {
      const Point place{random.Between(0, map.extent_x(), number, 2 * i),
                        random.Between(0, map.extent_y(), number, 2 * i + 1)};
      const double truth = DistanceByHand(grid, place);
      EXPECT_LE(map.Clearance(place), truth + 1e-9);
      EXPECT_GE(map.Clearance(place), truth - 1.5 * grid.resolution);
    }
  }
}

TEST(DistanceMapTest, OutsideOfTheGrid_NoClearance) {
  const DistanceMap map(Grid{2, 2, 0.1, {0, 0, 0, 0}});
  EXPECT_EQ(map.Clearance({-5.0, 0.1}), 0.0);
  EXPECT_EQ(map.Clearance({0.1, 1e9}), 0.0);
  EXPECT_EQ(map.SquaredCells(-1, 0), 0);
}

}  // namespace
}  // namespace latchwork::planning
