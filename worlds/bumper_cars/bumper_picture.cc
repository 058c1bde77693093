// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/bumper_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace latchwork::bumper_cars {
namespace {

constexpr double kPixels = 50;     // a metre
constexpr double kRemarkFor = 3;   // s
constexpr double kFlashFor = 0.4;  // s
constexpr double kHead = 0.9;      // m above the arena, for texts
constexpr double kFastest = 90;    // s; a longer run is played faster

std::string_view ColourOf(Attitude attitude) {
  constexpr std::array<std::string_view, 4> kColours{"#2f6fde", "#d6382e", "#3c9a4e", "#8a8f98"};
  return kColours.at(static_cast<std::size_t>(attitude));
}

void DrawFloor(sdk::Svg& svg, const Arena& arena) {
  svg.Rectangle({-0.2, -0.2}, {arena.size.x + 0.2, arena.size.y + kHead}, {.fill = "white"});
  svg.Rectangle({0, 0}, {arena.size.x, arena.size.y},
                {.fill = "#f2efe8", .stroke = "#343a46", .width = 0.12});
  svg.Circle({arena.gate.x, arena.gate.y}, 0.75,
             {.stroke = "#343a46", .width = 0.03, .dash = 0.12});
  svg.Text({arena.gate.x, arena.gate.y - 1.0}, "gate",
           {.size = 0.3, .anchor = sdk::SvgTextStyle::Anchor::kMiddle});
  for (const Pole& pole : arena.poles) {
    svg.Circle({pole.place.x, pole.place.y}, 0.4, {.fill = "#f5c542", .opacity = 0.35});
    svg.Circle({pole.place.x, pole.place.y}, kPoleRadius,
               {.fill = "#f5c542", .stroke = "#343a46", .width = 0.03});
  }
}

void DrawWay(sdk::Svg& svg, const std::vector<sdk::SvgKeyframe>& keyframes) {
  std::vector<sdk::SvgPoint> way;
  way.reserve(keyframes.size());
  for (const sdk::SvgKeyframe& keyframe : keyframes) way.push_back({keyframe.x, keyframe.y});
  svg.Polyline(way, {.stroke = "#2f6fde", .width = 0.04, .opacity = 0.3});
}

void DrawCar(sdk::Svg& svg, const Car& car, const std::vector<sdk::SvgKeyframe>& keyframes) {
  svg.Group(keyframes, [&] {
    svg.Circle({0, 0}, kCarRadius, {.fill = "#343a46"});
    svg.Circle({0, 0}, kCarRadius - 0.09, {.fill = ColourOf(car.attitude)});
    const std::array<sdk::SvgPoint, 3> nose{{{0.42, 0}, {0.22, 0.2}, {0.22, -0.2}}};
    svg.Polygon(nose, {.fill = "white"});
    svg.Circle({-0.1, 0}, 0.15, {.fill = "#f0d0b0"});
  });
  // The name goes along without turning.
  std::vector<sdk::SvgKeyframe> upright = keyframes;
  for (sdk::SvgKeyframe& keyframe : upright) keyframe.angle = 0;
  svg.Group(upright, [&] {
    svg.Text({0, 0.62}, car.driver, {.size = 0.28, .anchor = sdk::SvgTextStyle::Anchor::kMiddle});
  });
}

}  // namespace

void Film::Add(double seconds_now, const Arena& arena) {
  seconds = seconds_now;
  cars.resize(arena.cars.size());
  for (std::size_t i = 0; i < cars.size(); ++i) {
    const Car& car = arena.cars[i];
    cars[i].push_back(
        {.seconds = seconds, .x = car.place.x, .y = car.place.y, .angle = car.heading});
  }
}

bool DrawFilm(const Film& film, const Arena& arena, const std::filesystem::path& file) {
  sdk::Svg svg({-0.2, -0.2, arena.size.x + 0.2, arena.size.y + kHead}, kPixels, film.seconds,
               std::max(1.0, film.seconds / kFastest));
  DrawFloor(svg, arena);
  DrawWay(svg, film.cars[0]);
  for (std::size_t i = arena.cars.size(); i-- > 0;) DrawCar(svg, arena.cars[i], film.cars[i]);
  for (const Film::Flash& flash : film.flashes) {
    svg.Shown(flash.seconds, flash.seconds + kFlashFor, [&] {
      svg.Circle({flash.place.x, flash.place.y}, 0.12 + 0.15 * flash.closing,
                 {.fill = "#ff9d00", .opacity = 0.8});
    });
  }
  for (std::size_t i = 0; i < film.remarks.size(); ++i) {
    const Film::Remark& remark = film.remarks[i];
    const double next = i + 1 < film.remarks.size() ? film.remarks[i + 1].seconds : film.seconds;
    const double end = std::min(remark.seconds + kRemarkFor, std::max(next, remark.seconds + 0.5));
    svg.Shown(remark.seconds, i + 1 < film.remarks.size() ? end : film.seconds + 1, [&] {
      svg.Text({0, arena.size.y + 0.35}, fmt::format("{:.1f} s: {}", remark.seconds, remark.text),
               {.size = 0.35});
    });
  }
  return svg.Save(file);
}

}  // namespace latchwork::bumper_cars
