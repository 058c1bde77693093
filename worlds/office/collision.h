// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_COLLISION_H_
#define LATCHWORK_OFFICE_COLLISION_H_

#include <optional>
#include <vector>

#include "worlds/office/floor_map.h"
#include "worlds/office/geometry.h"

namespace latchwork::office {

struct CellIndex {
  int x = 0;
  int y = 0;
};

/// The occupied cell nearest to the centre that a disc overlaps, exact against the squares of the
/// cells; nothing when the disc is free. Touching is not overlapping.
std::optional<CellIndex> FindContact(const FloorMap& map, Point centre, double radius);

/// True if a disc can move from a to b in a straight line; sampled so finely that no cell corner is
/// jumped by more than a tenth of a cell.
bool IsLineFree(const FloorMap& map, Point a, Point b, double radius);

/// The cells whose square a rectangle overlaps.
std::vector<CellIndex> CellsOf(const FloorMap& map, const Rect& rect);
/// The cells of a door leaf: a segment, `thickness` metres wide.
std::vector<CellIndex> CellsOf(const FloorMap& map, const Segment& leaf, double thickness);

/// Covers or uncovers cells of a map.
void Cover(FloorMap& map, const std::vector<CellIndex>& cells);
void Uncover(FloorMap& map, const std::vector<CellIndex>& cells);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_COLLISION_H_
