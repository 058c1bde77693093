// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "latchwork/sdk/svg.h"
#include "worlds/office/floor_svg.h"
#include "worlds/office/picture.h"

namespace latchwork::office {
namespace {

constexpr double kLetters = 1.0;  // m

void DrawElevators(sdk::Svg& svg, const Building& building) {
  for (const ElevatorShaft& shaft : building.elevators) {
    svg.Rectangle({shaft.cab.x1, shaft.cab.y1}, {shaft.cab.x2, shaft.cab.y2},
                  {.fill = "currentColor", .opacity = 0.15});
    svg.Line({shaft.door.a.x, shaft.door.a.y}, {shaft.door.b.x, shaft.door.b.y},
             {.stroke = "currentColor", .width = 0.15, .opacity = 0.5});
    const Point middle = shaft.cab.centre();
    svg.Text(
        {middle.x, middle.y - kLetters / 3}, shaft.name.name(),
        {.size = kLetters, .anchor = sdk::SvgTextStyle::Anchor::kMiddle, .fill = "currentColor"});
  }
}

void DrawGoal(sdk::Svg& svg, const Point& goal) {
  for (const double radius : {0.45, 0.8}) {
    svg.Circle({goal.x, goal.y}, radius, {.stroke = "currentColor", .width = 0.15});
  }
}

}  // namespace

std::vector<std::filesystem::path> DrawPlans(const PictureScene& scene,
                                             const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> written;
  for (std::size_t i = 0; i < scene.building->floors.size(); ++i) {
    const Storey& storey = scene.building->floors[i];
    const Point origin = storey.map.origin();
    sdk::Svg svg({.x1 = origin.x,
                  .y1 = origin.y,
                  .x2 = origin.x + WidthOf(storey.map),
                  .y2 = origin.y + HeightOf(storey.map)},
                 kSvgPixels);
    DrawWalls(svg, storey.map, "currentColor");
    DrawElevators(svg, *scene.building);
    if (scene.goal_floor == static_cast<int>(i)) DrawGoal(svg, scene.goal);
    const auto file = folder / fmt::format("plan{}.svg", storey.number);
    if (svg.Save(file)) written.push_back(file);
  }
  return written;
}

}  // namespace latchwork::office
