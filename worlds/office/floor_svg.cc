// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/floor_svg.h"

#include <map>
#include <utility>

namespace latchwork::office {
namespace {

/// What neighbours overlap, so that no light shines between them, in metres.
constexpr double kSeam = 0.04;

sdk::SvgPoint CornerOf(const FloorMap& map, int x, int y) {
  return {map.origin().x + x * map.resolution(), map.origin().y + y * map.resolution()};
}

}  // namespace

/// Rectangles: runs of cells that repeat in the rows above are merged.
void DrawWalls(sdk::Svg& svg, const FloorMap& map, std::string_view colour) {
  std::map<std::pair<int, int>, int> open;  // run of cells -> its first row
  for (int y = 0; y <= map.height(); ++y) {
    std::map<std::pair<int, int>, int> now;
    for (int x = 0; y < map.height() && x < map.width(); ++x) {
      if (!map.IsWall(x, y)) continue;
      const int first = x;
      while (x < map.width() && map.IsWall(x, y)) ++x;
      const auto above = open.find({first, x});
      now[{first, x}] = above == open.end() ? y : above->second;
    }
    for (const auto& [run, first] : open) {
      if (now.contains(run)) continue;
      svg.Rectangle(CornerOf(map, run.first, first), CornerOf(map, run.second, y),
                    {.fill = colour, .stroke = colour, .width = kSeam});
    }
    open = std::move(now);
  }
}

}  // namespace latchwork::office
