// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_BOXES_H_
#define LATCHWORK_OFFICE_BOXES_H_

#include <cstdint>
#include <vector>

#include "worlds/office/building.h"

namespace latchwork::office {

struct Box {
  int floor = 0;
  Rect area;
};

/// Places up to `count` boxes of 0.3 to 0.6 m by seed. In a building with landmarks a box keeps
/// 0.45 m from every line of the landmark graph, so a passage of 0.9 m stays open, and 1 m from
/// doors and elevators; on a bare map it stands alone with 0.95 m free all round. Nothing comes
/// within 1.5 m of `keep_free`. Fewer boxes than asked for mean that no more found a place.
std::vector<Box> PlaceBoxes(const Building& building, int count, std::uint64_t seed, int floor,
                            Point keep_free);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_BOXES_H_
