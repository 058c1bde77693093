// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/picture.h"

#include <fmt/format.h>
#include <mrpt/img/CImage.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace latchwork::office {

namespace {

using mrpt::img::TColor;

constexpr Colour kWall{52, 58, 70};
constexpr Colour kUnknown{176, 180, 188};
constexpr Colour kFurniture{205, 192, 170};
constexpr Colour kCorridor{250, 249, 246};
constexpr Colour kCab{190, 214, 240};
constexpr std::array<Colour, 6> kRooms{{{244, 238, 226},
                                        {230, 241, 232},
                                        {231, 238, 247},
                                        {247, 234, 234},
                                        {240, 234, 246},
                                        {246, 243, 222}}};
constexpr int kMargin = 36;

TColor Mrpt(Colour c) { return {c.red, c.green, c.blue}; }

/// Draws one floor; pixel rows run from the top, metres from the bottom.
class FloorPicture {
 public:
  FloorPicture(const PictureScene& scene, int floor)
      : scene_(scene),
        floor_(floor),
        map_(scene.building->floors[static_cast<std::size_t>(floor)].map),
        zoom_(map_.width() > 1400 ? 1 : 2),
        image_(static_cast<unsigned>(map_.width() * zoom_ + 2 * kMargin),
               static_cast<unsigned>(map_.height() * zoom_ + 2 * kMargin), mrpt::img::CH_RGB) {
    image_.filledRectangle(0, 0, static_cast<int>(image_.getWidth()),
                           static_cast<int>(image_.getHeight()), TColor(255, 255, 255));
  }

  bool Save(const std::filesystem::path& file) {
    Cells();
    Boxes();
    Doors();
    Landmarks();
    Names();
    Tracks();
    Route();
    Ends();
    Remarks();
    Legend();
    return image_.saveToFile(file.string());
  }

 private:
  int X(double x) const {
    return kMargin +
           static_cast<int>(std::lround((x - map_.origin().x) / map_.resolution() * zoom_));
  }
  int Y(double y) const {
    return kMargin + map_.height() * zoom_ -
           static_cast<int>(std::lround((y - map_.origin().y) / map_.resolution() * zoom_));
  }

  void Line(Point a, Point b, const TColor& colour, unsigned width) {
    image_.line(X(a.x), Y(a.y), X(b.x), Y(b.y), colour, width);
  }

  void Dot(Point p, int radius, const TColor& colour) {
    const int x = X(p.x);
    const int y = Y(p.y);
    for (int dy = -radius; dy <= radius; ++dy) {
      const int half = static_cast<int>(std::sqrt(static_cast<double>(radius * radius - dy * dy)));
      image_.line(x - half, y + dy, x + half, y + dy, colour, 1);
    }
  }

  void Text(Point p, int dx, int dy, const std::string& text, const TColor& colour) {
    const int width = 6 * static_cast<int>(text.size());
    const int right = static_cast<int>(image_.getWidth()) - width - 4;
    image_.textOut(std::clamp(X(p.x) + dx, 4, std::max(4, right)), Y(p.y) + dy, text, colour);
  }

  const Room* RoomAt(Point p) const {
    for (const Room& room : scene_.building->rooms) {
      if (room.floor == floor_ && room.area.Contains(p)) return &room;
    }
    return nullptr;
  }

  Colour ColourOf(int x, int y) const {
    const Point middle{map_.origin().x + (x + 0.5) * map_.resolution(),
                       map_.origin().y + (y + 0.5) * map_.resolution()};
    const Room* room = RoomAt(middle);
    if (map_.IsWall(x, y)) {
      if (scene_.building->rooms.empty()) return kUnknown;
      return room != nullptr ? kFurniture : kWall;
    }
    if (room != nullptr) {
      const auto index = static_cast<std::size_t>(room - scene_.building->rooms.data());
      return kRooms[index % kRooms.size()];
    }
    for (const ElevatorShaft& shaft : scene_.building->elevators) {
      if (shaft.cab.Contains(middle)) return kCab;
    }
    return kCorridor;
  }

  void Cells() {
    for (int y = 0; y < map_.height(); ++y) {
      for (int x = 0; x < map_.width();) {
        const Colour colour = ColourOf(x, y);
        int end = x + 1;
        while (end < map_.width() && Same(ColourOf(end, y), colour)) ++end;
        const int top = kMargin + (map_.height() - 1 - y) * zoom_;
        image_.filledRectangle(kMargin + x * zoom_, top, kMargin + end * zoom_ - 1, top + zoom_ - 1,
                               Mrpt(colour));
        x = end;
      }
    }
  }

  static bool Same(Colour a, Colour b) {
    return a.red == b.red && a.green == b.green && a.blue == b.blue;
  }

  void Boxes() {
    for (const Box& box : scene_.record->boxes) {
      if (box.floor != floor_) continue;
      image_.filledRectangle(X(box.area.x1), Y(box.area.y2), X(box.area.x2), Y(box.area.y1),
                             TColor(222, 150, 62));
      image_.rectangle(X(box.area.x1), Y(box.area.y2), X(box.area.x2), Y(box.area.y1),
                       TColor(130, 78, 20), 1);
    }
  }

  void Doors() {
    for (std::size_t i = 0; i < scene_.building->doors.size(); ++i) {
      const Door& door = scene_.building->doors[i];
      if (door.floor != floor_) continue;
      const bool shut = scene_.shut_doors[i] != 0;
      Line(door.leaf.a, door.leaf.b, shut ? TColor(200, 30, 40) : TColor(214, 200, 178),
           shut ? 5 : 2);
    }
    for (const ElevatorShaft& shaft : scene_.building->elevators) {
      Line(shaft.door.a, shaft.door.b, TColor(70, 120, 190), 3);
    }
  }

  void Landmarks() {
    for (const Edge& edge : scene_.building->edges) {
      const Landmark& a = scene_.building->landmarks[edge.a];
      if (a.floor != floor_) continue;
      Line(a.place, scene_.building->landmarks[edge.b].place, TColor(222, 222, 226), 1);
    }
    for (const Landmark& landmark : scene_.building->landmarks) {
      if (landmark.floor == floor_) Dot(landmark.place, 2, TColor(190, 192, 200));
    }
  }

  void Names() {
    image_.selectTextFont("6x13");
    for (const Room& room : scene_.building->rooms) {
      if (room.floor != floor_) continue;
      Text({room.area.x1, room.area.y2}, 8, 20, std::string(room.name.name()),
           TColor(120, 120, 130));
    }
    for (const ElevatorShaft& shaft : scene_.building->elevators) {
      Text(shaft.cab.centre(), -6, -6, std::string(shaft.name.name()), TColor(50, 90, 160));
    }
  }

  void Tracks() {
    for (const RoutePoint& point : scene_.record->people) {
      if (point.floor == floor_) Dot(point.place, 2, TColor(206, 178, 222));
    }
  }

  void Route() {
    const auto& route = scene_.record->route;
    const double last = route.empty() ? 1.0 : std::max(1.0, static_cast<double>(route.back().tick));
    for (std::size_t i = 1; i < route.size(); ++i) {
      const bool joined = route[i].floor == floor_ && route[i - 1].floor == floor_;
      if (!joined) continue;
      const Colour colour = ColourOfTime(static_cast<double>(route[i].tick) / last);
      Line(route[i - 1].place, route[i].place, Mrpt(colour), 4);
    }
  }

  void Ends() {
    const auto& route = scene_.record->route;
    if (scene_.goal_floor == floor_) {
      image_.drawCircle(X(scene_.goal.x), Y(scene_.goal.y), 14, TColor(200, 30, 40), 2);
      image_.drawCircle(X(scene_.goal.x), Y(scene_.goal.y), 9, TColor(200, 30, 40), 2);
    }
    if (route.empty()) return;
    image_.selectTextFont("9x15");
    if (route.front().floor == floor_) {
      Dot(route.front().place, 8, TColor(30, 80, 200));
      Text(route.front().place, 12, 2, "start", TColor(30, 80, 200));
    }
    if (route.back().floor == floor_) {
      Dot(route.back().place, 8, TColor(200, 30, 40));
      Text(route.back().place, 12, 2, "end", TColor(200, 30, 40));
    }
  }

  void Remarks() {
    image_.selectTextFont("6x13");
    int row = 0;
    for (const Remark& remark : scene_.record->remarks) {
      if (remark.floor != floor_) continue;
      Dot(remark.place, 4, TColor(20, 20, 20));
      const double seconds = static_cast<double>(remark.tick) * scene_.tick_seconds;
      Text(remark.place, 10, 14 + 14 * (row % 4), fmt::format("{:.1f} s {}", seconds, remark.text),
           TColor(20, 20, 20));
      ++row;
    }
  }

  void Legend() {
    image_.selectTextFont("10x20");
    const Storey& storey = scene_.building->floors[static_cast<std::size_t>(floor_)];
    image_.textOut(kMargin, 8, fmt::format("floor {}", storey.number), TColor(40, 44, 52));
    const int y = static_cast<int>(image_.getHeight()) - kMargin / 2;
    const int length = static_cast<int>(std::lround(5.0 / map_.resolution() * zoom_));
    image_.line(kMargin, y, kMargin + length, y, TColor(40, 44, 52), 3);
    image_.textOut(kMargin + length + 10, y - 10, "5 m", TColor(40, 44, 52));
    const int left = static_cast<int>(image_.getWidth()) - kMargin - 240;
    for (int i = 0; i < 200; ++i) {
      image_.line(left + i, y - 4, left + i, y + 4, Mrpt(ColourOfTime(i / 200.0)), 1);
    }
    const auto& route = scene_.record->route;
    const double end = route.empty() ? 0.0 : static_cast<double>(route.back().tick);
    image_.selectTextFont("6x13");
    image_.textOut(left - 22, y - 6, "0 s", TColor(40, 44, 52));
    image_.textOut(left + 206, y - 6, fmt::format("{:.0f} s", end * scene_.tick_seconds),
                   TColor(40, 44, 52));
  }

  const PictureScene& scene_;
  int floor_;
  const FloorMap& map_;
  int zoom_;
  mrpt::img::CImage image_;
};

/// MRPT unpacks its fonts on first use and takes no lock; agents run side by side.
void LoadFontsOnce() {
  static const bool loaded = [] {
    mrpt::img::CImage(1, 1, mrpt::img::CH_RGB).selectTextFont("6x13");
    return true;
  }();
  (void)loaded;
}

}  // namespace

Colour ColourOfTime(double t) {
  constexpr std::array<std::array<double, 3>, 5> kStops{
      {{40, 70, 200}, {20, 150, 190}, {50, 170, 80}, {235, 175, 30}, {215, 50, 45}}};
  const double scaled = std::clamp(t, 0.0, 1.0) * (kStops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(scaled), kStops.size() - 2);
  const double part = scaled - static_cast<double>(low);
  const auto mix = [&](std::size_t channel) {
    return static_cast<std::uint8_t>(
        std::lround(kStops[low][channel] * (1 - part) + kStops[low + 1][channel] * part));
  };
  return {mix(0), mix(1), mix(2)};
}

std::vector<std::filesystem::path> DrawFloors(const PictureScene& scene,
                                              const std::filesystem::path& folder) {
  LoadFontsOnce();
  std::vector<std::filesystem::path> written;
  for (std::size_t i = 0; i < scene.building->floors.size(); ++i) {
    const auto file = folder / fmt::format("floor{}.png", scene.building->floors[i].number);
    if (FloorPicture(scene, static_cast<int>(i)).Save(file)) written.push_back(file);
  }
  return written;
}

}  // namespace latchwork::office
