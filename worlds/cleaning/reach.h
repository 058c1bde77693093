// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CLEANING_REACH_H_
#define LATCHWORK_CLEANING_REACH_H_

#include <vector>

#include "worlds/cleaning/floor_plan.h"

namespace latchwork::cleaning {

/// Which tiles, by index, a brush can come to: there is a place from which it reaches the middle of
/// the tile, and to which a disc of `radius` can be moved from the dock. Places are looked at 0.05
/// m apart.
std::vector<char> TilesInReach(const FloorPlan& plan, double radius, double brush);

}  // namespace latchwork::cleaning

#endif  // LATCHWORK_CLEANING_REACH_H_
