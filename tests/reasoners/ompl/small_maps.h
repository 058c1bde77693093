// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_OMPL_SMALL_MAPS_H_
#define LATCHWORK_TESTS_REASONERS_OMPL_SMALL_MAPS_H_

#include <algorithm>
#include <string_view>
#include <vector>

#include "reasoners/ompl/map/grid.h"

namespace latchwork::planning {

/// A map drawn with letters, north up: '#' is a block of `block` x `block` occupied cells.
inline Grid Drawn(const std::vector<std::string_view>& rows, int block = 10) {
  Grid grid{static_cast<int>(rows.front().size()) * block,
            static_cast<int>(rows.size()) * block,
            0.05,
            {}};
  for (int y = 0; y < grid.height; ++y) {
    const std::string_view row = rows[rows.size() - 1 - static_cast<std::size_t>(y / block)];
    for (int x = 0; x < grid.width; ++x) {
      grid.occupied.push_back(row[static_cast<std::size_t>(x / block)] == '#' ? 1 : 0);
    }
  }
  return grid;
}

/// 8 m x 6 m: two rooms, the wall between them has a door of 1.5 m at the top. A point of each.
inline Grid TwoRooms() {
  return Drawn({"################",  //
                "#..............#",  //
                "#..............#",  //
                "#..............#",  //
                "#......##......#",  //
                "#......##......#",  //
                "#......##......#",  //
                "#......##......#",  //
                "#......##......#",  //
                "#......##......#",  //
                "#......##......#",  //
                "################"});
}
inline constexpr Point kLeft{1.5, 1.5};
inline constexpr Point kRight{6.5, 1.5};

/// The same with the door walled up, one cell thick.
inline Grid WalledIn() {
  Grid grid = TwoRooms();
  for (int y = 0; y < grid.height; ++y) grid.occupied[grid.Index(80, y)] = 1;
  return grid;
}

}  // namespace latchwork::planning

#endif  // LATCHWORK_TESTS_REASONERS_OMPL_SMALL_MAPS_H_
