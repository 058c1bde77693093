// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_WORLDS_OFFICE_TEST_MAP_H_
#define LATCHWORK_TESTS_WORLDS_OFFICE_TEST_MAP_H_

#include <functional>

#include "worlds/office/floor_map.h"

namespace latchwork::office {

/// Cells of 0.05 m with the origin at 0, 0; occupied where `occupied` says so of a cell's middle.
inline Cells MakeCells(int width, int height, const std::function<bool(double, double)>& occupied) {
  Cells cells{width, height, 0.05, {0.0, 0.0}, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      cells.occupied.push_back(occupied((x + 0.5) * 0.05, (y + 0.5) * 0.05) ? 1 : 0);
    }
  }
  return cells;
}

/// A hall of 10 m x 6 m with walls of 0.1 m and a post of 0.2 m at 7, 4.
inline Cells Hall() {
  return MakeCells(200, 120, [](double x, double y) {
    return x < 0.1 || y < 0.1 || x > 9.9 || y > 5.9 || (x > 6.9 && x < 7.1 && y > 3.9 && y < 4.1);
  });
}

}  // namespace latchwork::office

#endif  // LATCHWORK_TESTS_WORLDS_OFFICE_TEST_MAP_H_
