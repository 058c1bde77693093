// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cart_pole/cart_pole_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace latchwork::cart_pole {

namespace {

using sdk::Svg;
using sdk::SvgKeyframe;
using sdk::SvgPoint;

constexpr double kEvery = 1.0 / 12;  // s
constexpr std::size_t kMostFrames = 1440;
constexpr double kWidth = 1000;  // pixels

}  // namespace

// All lengths of the picture are in shares of the track's half.

void CartPolePicture::Begin(double track_end, double pole_length, double fallen) {
  *this = CartPolePicture();
  track_end_ = track_end;
  pole_length_ = pole_length;
  fallen_ = fallen;
}

void CartPolePicture::Remember(double seconds, const Motion& motion) {
  if (seconds < next_at_ || frames_.size() >= kMostFrames) return;
  next_at_ = seconds + kEvery - 1e-6;
  frames_.push_back({seconds, motion.place, motion.angle});
}

std::vector<std::filesystem::path> CartPolePicture::Draw(
    const std::filesystem::path& folder) const {
  if (frames_.size() < 2) return {};
  const double top = 0.2 + pole_length_ / track_end_;
  const Svg::Area area{-1.15, -0.75, 1.15, top};
  Svg svg(area, kWidth / (area.x2 - area.x1), frames_.back().seconds, 1);
  svg.Rectangle({area.x1, area.y1}, {area.x2, area.y2}, {.fill = "#f4f5f7"});
  DrawScene(svg);
  DrawChart(svg);
  const std::filesystem::path file = folder / "cart_pole.svg";
  if (!svg.Save(file)) return {};
  return {file};
}

void CartPolePicture::DrawScene(Svg& svg) const {
  svg.Line({-1, 0}, {1, 0}, {.stroke = "#20242c", .width = 0.008});
  for (const double end : {-1.05, 1.05}) {
    svg.Line({end, 0}, {end, 0.12}, {.stroke = "#20242c", .width = 0.02});
  }
  svg.Line({0, -0.02}, {0, -0.04}, {.stroke = "#20242c", .width = 0.008});
  std::vector<SvgKeyframe> cart;
  std::vector<SvgKeyframe> pole;
  for (const Frame& frame : frames_) {
    cart.push_back({.seconds = frame.seconds, .x = frame.place / track_end_});
    pole.push_back({.seconds = frame.seconds, .y = 0.08, .angle = -frame.angle});
  }
  svg.Group(cart, [&] {
    svg.Rectangle({-0.07, 0.02}, {0.07, 0.08}, {.fill = "#2f6f9f"});
    for (const double wheel : {-0.045, 0.045}) {
      svg.Circle({wheel, 0.018}, 0.016, {.fill = "#20242c"});
    }
    svg.Group(pole, [&] {
      svg.Line({0, 0}, {0, pole_length_ / track_end_}, {.stroke = "#d33f49", .width = 0.018});
    });
    svg.Circle({0, 0.08}, 0.014, {.fill = "#20242c"});
  });
  for (const double at : pushes_) {
    if (at > frames_.back().seconds) continue;
    svg.Shown(at, at + 0.4, [&] {
      svg.Text({0, 0.12 + pole_length_ / track_end_}, "push",
               {.size = 0.06, .anchor = sdk::SvgTextStyle::Anchor::kMiddle, .fill = "#d33f49"});
    });
  }
}

double CartPolePicture::ChartX(double seconds) const {
  return -1 + 2 * seconds / frames_.back().seconds;
}

void CartPolePicture::DrawChart(Svg& svg) const {
  constexpr double kMiddle = -0.42;
  constexpr double kHalf = 0.25;
  std::vector<SvgPoint> places;
  std::vector<SvgPoint> angles;
  for (const Frame& frame : frames_) {
    const double x = ChartX(frame.seconds);
    places.push_back({x, kMiddle + kHalf * frame.place / track_end_});
    angles.push_back({x, kMiddle + kHalf * frame.angle / fallen_});
  }
  svg.Rectangle({-1, kMiddle - kHalf}, {1, kMiddle + kHalf}, {.fill = "#e3e6eb"});
  svg.Line({-1, kMiddle}, {1, kMiddle}, {.stroke = "#9aa3b2", .width = 0.003});
  for (const double at : pushes_) {
    if (at > frames_.back().seconds) continue;
    const double x = ChartX(at);
    svg.Line({x, kMiddle - kHalf}, {x, kMiddle - kHalf + 0.04},
             {.stroke = "#20242c", .width = 0.006});
  }
  svg.Polyline(places, {.stroke = "#2f6f9f", .width = 0.007});
  svg.Polyline(angles, {.stroke = "#d33f49", .width = 0.005});
  const std::vector<SvgKeyframe> marker = {{.seconds = 0, .x = -1},
                                           {.seconds = frames_.back().seconds, .x = 1}};
  svg.Group(marker, [&] {
    svg.Line({0, kMiddle - kHalf}, {0, kMiddle + kHalf}, {.stroke = "#20242c", .width = 0.004});
  });
  svg.Text(
      {-1, kMiddle + kHalf + 0.02},
      fmt::format("cart, blue (band: {:.1f} m), and angle, red (band: {:.2f} rad), over {:.0f} "
                  "s; marks: pushes",
                  track_end_, fallen_, frames_.back().seconds),
      {.size = 0.045});
}

}  // namespace latchwork::cart_pole
