// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <map>
#include <utility>

#include "worlds/office/picture.h"

namespace latchwork::office {

namespace {

constexpr double kPixels = 20.0;  // a metre
constexpr double kGap = 2.0;      // metres between floors

/// The walls as one path of rectangles: runs of cells that repeat in the rows above are merged.
std::string WallPath(const FloorMap& map) {
  std::string path;
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
      fmt::format_to(std::back_inserter(path), "M{} {}H{}V{}H{}Z", run.first, map.height() - first,
                     run.second, map.height() - y, run.first);
    }
    open = std::move(now);
  }
  return path;
}

class RouteSvg {
 public:
  explicit RouteSvg(const PictureScene& scene) : scene_(scene) {}

  std::string Write() {
    double top = 0.0;
    double width = 0.0;
    for (std::size_t i = 0; i < scene_.building->floors.size(); ++i) {
      const FloorMap& map = scene_.building->floors[i].map;
      Floor(static_cast<int>(i), top);
      top += map.height() * map.resolution() + kGap;
      width = std::max(width, map.width() * map.resolution());
    }
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"white\"/>\n{}</svg>\n",
        width * kPixels, top * kPixels, body_);
  }

 private:
  template <typename... Arguments>
  void Add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(body_), format, std::forward<Arguments>(arguments)...);
  }

  void Floor(int floor, double top) {
    const Storey& storey = scene_.building->floors[static_cast<std::size_t>(floor)];
    const FloorMap& map = storey.map;
    Add("<g transform=\"translate(0 {:.1f})\">\n", (top + kGap / 2) * kPixels);
    Add("<text x=\"4\" y=\"-6\">floor {}</text>\n", storey.number);
    Add("<path transform=\"scale({:.4f})\" fill=\"#343a46\" d=\"{}\"/>\n",
        map.resolution() * kPixels, WallPath(map));
    for (const Box& box : scene_.record->boxes) {
      if (box.floor != floor) continue;
      Add("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#de963e\"/>\n",
          X(map, box.area.x1), Y(map, box.area.y2), (box.area.x2 - box.area.x1) * kPixels,
          (box.area.y2 - box.area.y1) * kPixels);
    }
    Route(floor, map);
    for (const Remark& remark : scene_.record->remarks) {
      if (remark.floor != floor) continue;
      Add("<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"3\"/><text x=\"{0:.1f}\" y=\"{1:.1f}\" "
          "dx=\"6\" dy=\"14\">{2:.1f} s {3}</text>\n",
          X(map, remark.place.x), Y(map, remark.place.y),
          static_cast<double>(remark.tick) * scene_.tick_seconds, remark.text);
    }
    Add("</g>\n");
  }

  static double X(const FloorMap& map, double x) { return (x - map.origin().x) * kPixels; }
  static double Y(const FloorMap& map, double y) {
    return (map.origin().y + map.height() * map.resolution() - y) * kPixels;
  }

  void Route(int floor, const FloorMap& map) {
    const auto& route = scene_.record->route;
    const double last = route.empty() ? 1.0 : std::max(1.0, static_cast<double>(route.back().tick));
    for (std::size_t i = 1; i < route.size(); ++i) {
      if (route[i].floor != floor || route[i - 1].floor != floor) continue;
      const Colour c = ColourOfTime(static_cast<double>(route[i].tick) / last);
      Add("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#{:02x}{:02x}{:02x}\" "
          "stroke-width=\"3\" stroke-linecap=\"round\"/>\n",
          X(map, route[i - 1].place.x), Y(map, route[i - 1].place.y), X(map, route[i].place.x),
          Y(map, route[i].place.y), c.red, c.green, c.blue);
    }
  }

  const PictureScene& scene_;
  std::string body_;
};

}  // namespace

std::vector<std::filesystem::path> DrawRoute(const PictureScene& scene,
                                             const std::filesystem::path& folder) {
  const auto file = folder / "route.svg";
  std::ofstream out(file, std::ios::binary);
  out << RouteSvg(scene).Write();
  out.close();
  if (!out) return {};
  return {file};
}

}  // namespace latchwork::office
