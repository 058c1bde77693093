// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "latchwork/sdk/svg.h"
#include "worlds/office/floor_svg.h"
#include "worlds/office/picture.h"

namespace latchwork::office {

namespace {

constexpr double kGap = 2.0;  // metres between floors

/// The floors below each other, each in the frame of its map.
class RouteSvg {
 public:
  RouteSvg(const PictureScene& scene, double width, double height)
      : scene_(scene), svg_({.x2 = width, .y2 = height}, kSvgPixels) {
    svg_.Rectangle({0, 0}, {width, height}, {.fill = "white"});
    for (std::size_t i = 0; i < scene.building->floors.size(); ++i) {
      const FloorMap& map = scene.building->floors[i].map;
      height -= kGap / 2 + HeightOf(map);
      svg_.Group({{.x = -map.origin().x, .y = height - map.origin().y}},
                 [&] { Floor(static_cast<int>(i)); });
      height -= kGap / 2;
    }
  }

  const sdk::Svg& svg() const { return svg_; }

 private:
  void Floor(int floor) {
    const Storey& storey = scene_.building->floors[static_cast<std::size_t>(floor)];
    const Point origin = storey.map.origin();
    svg_.Text({origin.x + 0.2, origin.y + HeightOf(storey.map) + 0.3},
              fmt::format("floor {}", storey.number), {.size = kLetters});
    DrawWalls(svg_, storey.map, "#343a46");
    for (const Box& box : scene_.record->boxes) {
      if (box.floor != floor) continue;
      svg_.Rectangle({box.area.x1, box.area.y1}, {box.area.x2, box.area.y2}, {.fill = "#de963e"});
    }
    Route(floor);
    Ends(floor);
    for (const Remark& remark : scene_.record->remarks) {
      if (remark.floor != floor) continue;
      svg_.Circle({remark.place.x, remark.place.y}, 0.15, {.fill = "black"});
      const double seconds = static_cast<double>(remark.tick) * scene_.tick_seconds;
      Label({remark.place.x + 0.3, remark.place.y - 0.7},
            fmt::format("{:.1f} s {}", seconds, remark.text));
    }
  }

  void Route(int floor) {
    const auto& route = scene_.record->route;
    const double last = route.empty() ? 1.0 : std::max(1.0, static_cast<double>(route.back().tick));
    for (std::size_t i = 1; i < route.size(); ++i) {
      if (route[i].floor != floor || route[i - 1].floor != floor) continue;
      const Colour c = ColourOfTime(static_cast<double>(route[i].tick) / last);
      const std::string colour = fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue);
      svg_.Line({route[i - 1].place.x, route[i - 1].place.y}, {route[i].place.x, route[i].place.y},
                {.stroke = colour, .width = 0.15});
    }
  }

  /// Where the route begins, green, and where it ends, red.
  void Ends(int floor) {
    const auto& route = scene_.record->route;
    if (route.empty()) return;
    const auto mark = [&](const auto& at, std::string_view colour, const std::string& text) {
      if (at.floor != floor) return;
      svg_.Circle({at.place.x, at.place.y}, 0.35, {.stroke = colour, .width = 0.15});
      Label({at.place.x + 0.5, at.place.y + 0.4}, text);
    };
    mark(route.front(), "#2f9e44", "start");
    mark(route.back(), "#e03131", "end");
  }

  /// Black letters that can be read on walls, too.
  void Label(sdk::SvgPoint place, const std::string& text) {
    constexpr double kRim = 0.05;  // m
    for (const auto& [x, y] : {std::pair{-kRim, 0.0}, {kRim, 0.0}, {0.0, -kRim}, {0.0, kRim}}) {
      svg_.Text({place.x + x, place.y + y}, text, {.size = kLetters, .fill = "white"});
    }
    svg_.Text(place, text, {.size = kLetters});
  }

  static constexpr double kLetters = 0.6;  // m

  const PictureScene& scene_;
  sdk::Svg svg_;
};

}  // namespace

std::vector<std::filesystem::path> DrawRoute(const PictureScene& scene,
                                             const std::filesystem::path& folder) {
  double width = 0.0;
  double height = 0.0;
  for (const Storey& storey : scene.building->floors) {
    width = std::max(width, WidthOf(storey.map));
    height += HeightOf(storey.map) + kGap;
  }
  const auto file = folder / "route.svg";
  if (!RouteSvg(scene, width, height).svg().Save(file)) return {};
  return {file};
}

}  // namespace latchwork::office
