// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_FLOOR_SVG_H_
#define LATCHWORK_OFFICE_FLOOR_SVG_H_

#include <string_view>

#include "latchwork/sdk/svg.h"
#include "worlds/office/floor_map.h"

namespace latchwork::office {

constexpr double kSvgPixels = 20.0;  ///< A metre in drawings of floors.

inline double WidthOf(const FloorMap& map) { return map.width() * map.resolution(); }
inline double HeightOf(const FloorMap& map) { return map.height() * map.resolution(); }

/// Draws what is no free space of a map, in its coordinates.
void DrawWalls(sdk::Svg& svg, const FloorMap& map, std::string_view colour);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_FLOOR_SVG_H_
