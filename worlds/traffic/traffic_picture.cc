// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/traffic_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace latchwork::traffic {

namespace {

using sdk::Svg;
using sdk::SvgKeyframe;
using sdk::SvgPoint;

constexpr double kHalfView = 110;  // m of road to each side of the agent's car
constexpr double kEvery = 0.5;     // s
constexpr std::size_t kMostFrames = 480;
constexpr double kRoadY = 36;  // the right edge of the road
constexpr double kChartY = 4;
constexpr double kChartHeight = 20;
constexpr double kPixels = 5;  // per m

const char* ColourOf(double length) { return length > 10 ? "#8a6d3b" : "#7c8aa0"; }

void DrawCar(Svg& svg, double length, std::string_view colour) {
  svg.Rectangle({-length / 2, -0.9}, {length / 2, 0.9},
                {.fill = colour, .stroke = "#20242c", .width = 0.15});
  svg.Rectangle({length / 2 - 1.9, -0.7}, {length / 2 - 1.2, 0.7}, {.fill = "#20242c"});
}

}  // namespace

void TrafficPicture::Begin(const RoadSetup& setup, double exit) {
  *this = TrafficPicture();
  lanes_ = setup.lanes;
  speed_limit_ = setup.speed_limit;
  exit_ = exit;
}

void TrafficPicture::Remember(double seconds, double distance, double travelled, const Road& road) {
  car_count_ = road.cars().size();
  const double exit = distance - travelled + exit_;
  if (exits_.empty() || exit > exits_.back() + 1) exits_.push_back(exit);
  if (seconds < next_at_ || frames_.size() >= kMostFrames) return;
  next_at_ = seconds + kEvery - 1e-6;
  const Car& me = road.cars()[Road::kAgent];
  Frame frame{seconds, distance, me.speed, me.y, {}};
  for (std::size_t i = 1; i < car_count_; ++i) {
    const Car& car = road.cars()[i];
    double x = road.Forward(me.s, car.s);
    if (x > road.setup().length / 2) x -= road.setup().length;
    if (std::abs(x) <= kHalfView + 15) frame.cars.push_back({i, x, car.y, car.length});
  }
  frames_.push_back(std::move(frame));
}

std::vector<std::filesystem::path> TrafficPicture::Draw(const std::filesystem::path& folder) const {
  if (frames_.size() < 2) return {};
  const Svg::Area area{-kHalfView, 0, kHalfView, kRoadY + RoadHeight() + 8};
  Svg svg(area, kPixels, frames_.back().seconds, 2);
  svg.Rectangle({area.x1, area.y1}, {area.x2, area.y2}, {.fill = "#f4f5f7"});
  DrawRoad(svg);
  DrawCars(svg);
  DrawAgent(svg);
  DrawChart(svg);
  const std::filesystem::path file = folder / "traffic.svg";
  if (!svg.Save(file)) return {};
  return {file};
}

void TrafficPicture::DrawRoad(Svg& svg) const {
  svg.Rectangle({-kHalfView, kRoadY}, {kHalfView, kRoadY + RoadHeight()}, {.fill = "#4a4f59"});
  std::vector<SvgKeyframe> moving;
  for (const Frame& frame : frames_) {
    moving.push_back({.seconds = frame.seconds, .x = -frame.distance});
  }
  const double end = frames_.back().distance + 2 * kHalfView;
  svg.Group(moving, [&] {
    for (int lane = 1; lane < lanes_; ++lane) {
      const double y = kRoadY + lane * kLaneWidth;
      svg.Line({-2 * kHalfView, y}, {end, y}, {.stroke = "white", .width = 0.25, .dash = 6});
    }
    for (const double exit : exits_) {
      const std::vector<SvgPoint> ramp = {{exit - 10, kRoadY + 0.1},
                                          {exit + 30, kRoadY - 6},
                                          {exit + 38, kRoadY - 6},
                                          {exit + 15, kRoadY + 0.1}};
      svg.Polygon(ramp, {.fill = "#4a4f59"});
      svg.Text({exit - 12, kRoadY - 4}, "exit",
               {.size = 3.5, .anchor = sdk::SvgTextStyle::Anchor::kEnd});
    }
  });
}

const TrafficPicture::Seen* TrafficPicture::Find(std::size_t frame, std::size_t car) const {
  const auto& cars = frames_[frame].cars;
  const auto found =
      std::find_if(cars.begin(), cars.end(), [&](const Seen& s) { return s.car == car; });
  return found == cars.end() ? nullptr : &*found;
}

void TrafficPicture::DrawCars(Svg& svg) const {
  for (std::size_t car = 1; car < car_count_; ++car) {
    std::size_t frame = 0;
    while (frame < frames_.size()) frame = DrawStay(svg, car, frame);
  }
}

std::size_t TrafficPicture::DrawStay(Svg& svg, std::size_t car, std::size_t first) const {
  std::vector<SvgKeyframe> moving;
  double length = 0;
  std::size_t frame = first;
  for (; frame < frames_.size(); ++frame) {
    const Seen* seen = Find(frame, car);
    if (seen == nullptr) break;
    length = seen->length;
    moving.push_back(
        {.seconds = frames_[frame].seconds, .x = seen->x, .y = kRoadY + seen->y + kLaneWidth / 2});
  }
  if (moving.empty()) return first + 1;
  // A stay that lasts to the end of the run lasts to the end of the animation.
  const double until = frame < frames_.size() ? moving.back().seconds : frames_.back().seconds + 1;
  const double from = first == 0 ? 0 : moving.front().seconds;
  svg.Shown(from, until,
            [&] { svg.Group(moving, [&] { DrawCar(svg, length, ColourOf(length)); }); });
  return frame;
}

void TrafficPicture::DrawAgent(Svg& svg) const {
  std::vector<SvgKeyframe> moving;
  for (const Frame& frame : frames_) {
    moving.push_back({.seconds = frame.seconds, .x = 0, .y = kRoadY + frame.y + kLaneWidth / 2});
  }
  svg.Group(moving, [&] { DrawCar(svg, 4.5, "#d33f49"); });
}

double TrafficPicture::ChartX(double distance) const {
  const double share = distance / std::max(frames_.back().distance, 1.0);
  return -kHalfView + 8 + share * (2 * kHalfView - 16);
}

void TrafficPicture::DrawChart(Svg& svg) const {
  const double lane_height = 6.0 / lanes_;
  std::vector<SvgPoint> lanes;
  std::vector<SvgPoint> speeds;
  std::vector<SvgKeyframe> marker;
  for (const Frame& frame : frames_) {
    const double x = ChartX(frame.distance);
    lanes.push_back({x, kChartY + 14 + (frame.y / kLaneWidth + 0.5) * lane_height});
    speeds.push_back({x, kChartY + 10 * frame.speed / speed_limit_});
    marker.push_back({.seconds = frame.seconds, .x = x});
  }
  const double left = ChartX(0);
  const double right = ChartX(frames_.back().distance);
  svg.Rectangle({left, kChartY + 14}, {right, kChartY + kChartHeight}, {.fill = "#e3e6eb"});
  svg.Line({left, kChartY}, {right, kChartY}, {.stroke = "#20242c", .width = 0.2});
  svg.Line({left, kChartY + 10}, {right, kChartY + 10},
           {.stroke = "#9aa3b2", .width = 0.2, .dash = 2});
  for (const double exit : exits_) {
    if (exit > frames_.back().distance + 20) continue;
    const double x = std::min(ChartX(exit), right);
    svg.Line({x, kChartY}, {x, kChartY + kChartHeight}, {.stroke = "#20242c", .width = 0.4});
  }
  svg.Polyline(lanes, {.stroke = "#d33f49", .width = 0.5});
  svg.Polyline(speeds, {.stroke = "#2f6f9f", .width = 0.5});
  svg.Group(marker, [&] {
    svg.Line({0, kChartY}, {0, kChartY + kChartHeight}, {.stroke = "#d33f49", .width = 0.3});
  });
  svg.Text({left, kChartY + kChartHeight + 1}, "lane over the way; right lane below",
           {.size = 2.6});
  svg.Text({left, kChartY + 10.8}, fmt::format("speed; dashed: {:.0f} m/s", speed_limit_),
           {.size = 2.6});
  svg.Text({left, kRoadY + RoadHeight() + 3},
           fmt::format("{:.0f} s of driving, {:.0f} m, shown twice as fast", frames_.back().seconds,
                       frames_.back().distance),
           {.size = 3.2});
}

}  // namespace latchwork::traffic
