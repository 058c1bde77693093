// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/garden_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "latchwork/sdk/svg.h"

namespace latchwork::garden {

namespace {

using sdk::Svg;
using sdk::SvgKeyframe;
using sdk::SvgPoint;

constexpr double kRow = 1.0;    // height of a bed's chart
constexpr double kWide = 12.0;  // of the chart
constexpr double kLeft = 1.0;

/// The chart of a season: a row for the weather, a row for each bed.
class Season {
 public:
  explicit Season(const GardenState& state)
      : state_(state),
        hours_(std::max(24.0, state.hour)),
        height_(kRow * 1.2 * static_cast<double>(state.beds.size() + 1) + 0.6),
        svg_({.x1 = 0, .y1 = 0, .x2 = kLeft + kWide + 1.6, .y2 = height_}, 80) {}

  bool Save(const std::filesystem::path& file) {
    svg_.Rectangle({0, 0}, {kLeft + kWide + 1.6, height_}, {.fill = "white"});
    DrawWeather(Floor(0));
    for (std::size_t bed = 0; bed < state_.beds.size(); ++bed) DrawBed(bed, Floor(bed + 1));
    DrawDays();
    svg_.Text(
        {0.05, 0.12},
        "blue: moisture, green: food, orange: weight of each pumpkin; grey: covered. Weather: "
        "grey line: temperature; yellow: drought; red: frost; bars: rain",
        {.size = 0.17});
    return svg_.Save(file);
  }

 private:
  double Floor(std::size_t row) const {
    return height_ - kRow * 1.2 * static_cast<double>(row + 1);
  }
  double X(double hour) const { return kLeft + kWide * hour / hours_; }

  void Curve(double floor, std::string_view colour,
             const std::function<double(const Moment&)>& value) {
    std::vector<SvgPoint> points;
    for (const Moment& moment : state_.moments) {
      points.push_back({X(moment.hour), floor + kRow * std::clamp(value(moment), 0.0, 1.0)});
    }
    svg_.Polyline(points, {.stroke = colour, .width = 0.02});
  }

  void DrawWeather(double floor) {
    svg_.Text({0.05, floor + 0.4}, "weather", {.size = 0.2});
    const int days = static_cast<int>(hours_ / 24);
    for (int day = 0; day < days; ++day) {
      const Day& weather = state_.weather.OfDay(day);
      const double x = X(24.0 * day);
      const double wide = X(24.0) - X(0);
      if (weather.drought) {
        svg_.Rectangle({x, floor}, {x + wide, floor + kRow}, {.fill = "#fff3bf"});
      }
      svg_.Rectangle({x, floor}, {x + wide * 0.8, floor + kRow * std::min(1.0, weather.rain / 40)},
                     {.fill = "#74a9e0"});
      if (weather.low < 0) {
        svg_.Rectangle({x, floor}, {x + wide * 0.5, floor + kRow}, {.fill = "#e03131"});
      }
    }
    Curve(floor, "#868e96", [](const Moment& m) { return (m.temperature + 5) / 40; });
  }

  /// The time axis: some ten of the days, from 1.
  void DrawDays() {
    const int days = static_cast<int>(hours_ / 24);
    for (int day = 0; day < days; day += std::max(1, days / 10)) {
      const double x = X(24.0 * day);
      svg_.Line({x, 0.52}, {x, 0.6}, {.stroke = "#343a46", .width = 0.01});
      svg_.Text({x, 0.36}, fmt::format("day {}", day + 1), {.size = 0.15});
    }
  }

  void DrawBed(std::size_t bed, double floor) {
    svg_.Text({0.05, floor + 0.4}, state_.NameOf(bed), {.size = 0.2});
    for (const Moment& moment : state_.moments) {
      if (!moment.beds[bed].covered) continue;
      svg_.Rectangle({X(moment.hour), floor}, {X(moment.hour + 2), floor + kRow},
                     {.fill = "#dee2e6"});
    }
    svg_.Line({kLeft, floor}, {kLeft + kWide, floor}, {.stroke = "#343a46", .width = 0.01});
    Curve(floor, "#1c7ed6", [&](const Moment& m) { return m.beds[bed].moisture; });
    Curve(floor, "#2f9e44", [&](const Moment& m) { return m.beds[bed].food / 60; });
    for (std::size_t n = 0; n < state_.beds[bed].pumpkins().size(); ++n) {
      Curve(floor, "#e8590c", [&](const Moment& m) { return m.beds[bed].weights[n] / 30; });
    }
    svg_.Text({kLeft + kWide + 0.1, floor + 0.4},
              fmt::format("{:.0f} kg", state_.beds[bed].weight()), {.size = 0.22});
  }

  const GardenState& state_;
  double hours_;
  double height_;
  Svg svg_;
};

constexpr double kMetre = 0.05;       // of the path, in units of the drawing
constexpr double kSpeed = 3600 * 12;  // half a day in a second

/// The garden from above: the path from the well, beds beside it.
class Plan {
 public:
  explicit Plan(const GardenState& state)
      : state_(state),
        width_(X(state.beds.size() - 1) + 1.6),
        svg_({.x1 = -1, .y1 = -0.8, .x2 = width_, .y2 = 3.6}, 80, state.hour * 3600, kSpeed) {}

  bool Save(const std::filesystem::path& file) {
    svg_.Rectangle({-1, -0.8}, {width_, 3.6}, {.fill = "#e9f5db"});
    svg_.Rectangle({-0.5, -0.15}, {width_ - 0.5, 0.15}, {.fill = "#d8c3a5"});
    svg_.Circle({0, 0}, 0.3, {.fill = "#74a9e0"});
    svg_.Text({0, -0.6}, "well", {.size = 0.25, .anchor = sdk::SvgTextStyle::Anchor::kMiddle});
    for (std::size_t bed = 0; bed < state_.beds.size(); ++bed) DrawBed(bed);
    DrawSky();
    std::vector<SvgKeyframe> frames;
    for (const Moment& moment : state_.moments) {
      frames.push_back({.seconds = moment.hour * 3600, .x = moment.way * kMetre});
    }
    svg_.Group(frames, [&] { svg_.Circle({0, 0}, 0.14, {.fill = "#3b5bdb"}); });
    return svg_.Save(file);
  }

 private:
  double X(std::size_t bed) const { return state_.gardener.WayTo(bed) * kMetre; }

  void DrawBed(std::size_t bed) {
    const double x = X(bed);
    svg_.Rectangle({x - 0.8, 0.3}, {x + 0.8, 2.3}, {.fill = "#9c7a54"});
    std::vector<SvgKeyframe> wet;
    std::vector<SvgKeyframe> cover;
    for (const Moment& moment : state_.moments) {
      const double at = moment.hour * 3600;
      wet.push_back({.seconds = at, .opacity = std::min(1.0, moment.beds[bed].moisture)});
      cover.push_back({.seconds = at, .opacity = moment.beds[bed].covered ? 0.75 : 0.0});
    }
    svg_.Group(wet, [&] { svg_.Rectangle({x - 0.8, 0.3}, {x + 0.8, 2.3}, {.fill = "#4a3421"}); });
    for (std::size_t n = 0; n < state_.beds[bed].pumpkins().size(); ++n) DrawPumpkin(bed, n);
    svg_.Group(cover, [&] { svg_.Rectangle({x - 0.8, 0.3}, {x + 0.8, 2.3}, {.fill = "#f1f3f5"}); });
    svg_.Text({x, -0.6}, state_.NameOf(bed),
              {.size = 0.25, .anchor = sdk::SvgTextStyle::Anchor::kMiddle});
  }

  void DrawPumpkin(std::size_t bed, std::size_t n) {
    const double count = static_cast<double>(state_.beds[bed].pumpkins().size());
    const double y = 0.3 + 2.0 * (static_cast<double>(n) + 0.5) / count;
    std::vector<SvgKeyframe> frames;
    for (const Moment& moment : state_.moments) {
      const double weight = moment.beds[bed].weights[n];
      frames.push_back({.seconds = moment.hour * 3600,
                        .x = X(bed) + (n % 2 == 0 ? -0.3 : 0.3),
                        .y = y,
                        .scale = std::cbrt(std::abs(weight) / 28),
                        .opacity = weight < 0 ? 0.2 : 1});
    }
    svg_.Group(frames, [&] {
      svg_.Circle({0, 0}, 0.42, {.fill = "#e8590c"});
      svg_.Line({0, -0.42}, {0, 0.42}, {.stroke = "#d9480f", .width = 0.05});
      svg_.Rectangle({-0.05, 0.38}, {0.05, 0.55}, {.fill = "#2b8a3e"});
    });
  }

  /// A band of sky, which shows rain.
  void DrawSky() {
    std::vector<SvgKeyframe> rain;
    for (const Moment& moment : state_.moments) {
      rain.push_back(
          {.seconds = moment.hour * 3600, .opacity = moment.sky == Sky::kRain ? 1.0 : 0.0});
    }
    svg_.Rectangle({-1, 2.7}, {width_, 3.6}, {.fill = "#a5d8ff"});
    svg_.Group(rain, [&] {
      svg_.Rectangle({-1, 2.7}, {width_, 3.6}, {.fill = "#5c7080"});
      svg_.Text({0, 3}, "rain", {.size = 0.4, .fill = "white"});
    });
  }

  const GardenState& state_;
  double width_;
  Svg svg_;
};

}  // namespace

std::vector<std::filesystem::path> DrawGarden(const GardenState& state,
                                              const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> written;
  const std::filesystem::path season = folder / "season.svg";
  const std::filesystem::path garden = folder / "garden.svg";
  if (state.moments.empty()) return written;
  if (Season(state).Save(season)) written.push_back(season);
  if (Plan(state).Save(garden)) written.push_back(garden);
  return written;
}

}  // namespace latchwork::garden
