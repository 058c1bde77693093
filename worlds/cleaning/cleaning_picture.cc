// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cleaning/cleaning_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "latchwork/sdk/svg.h"

namespace latchwork::cleaning {

namespace {

using sdk::Svg;
using sdk::SvgKeyframe;
using sdk::SvgPoint;

constexpr double kPixels = 40;     // a metre
constexpr double kSpeed = 20;      // times as fast as it happened
constexpr std::size_t kEvery = 4;  // points of the route for one of the animation
constexpr std::string_view kDirt = "#cbb994";

std::string ColourOf(double part) {
  const auto channel = [&](double from, double to) {
    return static_cast<int>(std::lround(from + (to - from) * part));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(0x25, 0xc8), channel(0x6a, 0x2f),
                     channel(0xc0, 0x3c));
}

std::string_view ColourOf(Surface surface) {
  if (surface == Surface::kWall) return "#343a46";
  return surface == Surface::kBox ? "#de963e" : "#8b93a3";
}

void DrawTile(Svg& svg, Tile tile, std::string_view fill) {
  svg.Rectangle({tile.i * kTile, tile.j * kTile}, {(tile.i + 1) * kTile, (tile.j + 1) * kTile},
                {.fill = fill});
}

/// What neighbours overlap, so that no light shines between them, in metres.
constexpr double kSeam = 0.03;

/// Everything that stands, a rectangle for a run of equal tiles in a row.
void DrawPlan(Svg& svg, const FloorPlan& plan) {
  for (int j = 0; j < plan.height(); ++j) {
    for (int i = 0; i < plan.width();) {
      const Surface surface = plan.At({i, j});
      const int first = i;
      while (i < plan.width() && plan.At({i, j}) == surface) ++i;
      if (surface == Surface::kFloor) continue;
      svg.Rectangle({first * kTile, j * kTile}, {i * kTile, (j + 1) * kTile},
                    {.fill = ColourOf(surface), .stroke = ColourOf(surface), .width = kSeam});
    }
  }
  const Point home = CentreOf(plan.dock());
  svg.Circle({home.x, home.y}, 0.35, {.fill = "#7fc48a"});
}

Svg Empty(const FloorPlan& plan, double seconds) {
  const double width = plan.width() * kTile;
  const double height = plan.height() * kTile;
  Svg svg({.x1 = 0, .y1 = 0, .x2 = width, .y2 = height + 0.7}, kPixels, seconds, kSpeed);
  svg.Rectangle({0, 0}, {width, height + 0.7}, {.fill = "white"});
  return svg;
}

bool DrawRoute(const CleaningState& state, const std::filesystem::path& file) {
  Svg svg = Empty(state.plan, 0);
  for (std::size_t tile = 0; tile < state.plan.size(); ++tile) {
    if (state.dirty[tile] != 0) DrawTile(svg, state.plan.TileOf(tile), kDirt);
  }
  DrawPlan(svg, state.plan);
  constexpr std::size_t kPieces = 40;
  const std::size_t size = state.route.size();
  for (std::size_t piece = 0; piece < kPieces && size > 1; ++piece) {
    std::vector<SvgPoint> points;
    const std::size_t end = std::min((piece + 1) * size / kPieces, size - 1);
    for (std::size_t i = piece * size / kPieces; i <= end; ++i) {
      points.push_back({state.route[i].pose.x, state.route[i].pose.y});
    }
    const std::string colour = ColourOf(static_cast<double>(piece) / (kPieces - 1));
    svg.Polyline(points, {.stroke = colour, .width = 0.05});
  }
  svg.Text({0.1, state.plan.height() * kTile + 0.2},
           fmt::format("{:.1f} % clean after {:.0f} s; blue: early, red: late",
                       100 * state.CleanPart(), size == 0 ? 0.0 : state.route.back().seconds),
           {.size = 0.4});
  return svg.Save(file);
}

void DrawBattery(Svg& svg, const CleaningState& state) {
  const double y = state.plan.height() * kTile + 0.15;
  svg.Text({0.1, y}, "battery", {.size = 0.4});
  svg.Rectangle({1.8, y}, {6.8, y + 0.4}, {.fill = "#eeeeee"});
  std::vector<SvgKeyframe> frames;
  for (std::size_t i = 0; i < state.route.size(); i += kEvery) {
    frames.push_back(
        {.seconds = state.route[i].seconds, .x = 1.8 + 5 * state.route[i].charge, .y = y + 0.2});
  }
  svg.Group(frames, [&] { svg.Rectangle({-0.06, -0.2}, {0.06, 0.2}, {.fill = "#2f9e44"}); });
}

void DrawRobot(Svg& svg, const CleaningState& state) {
  std::vector<SvgKeyframe> frames;
  for (std::size_t i = 0; i < state.route.size(); i += kEvery) {
    const RoutePoint& point = state.route[i];
    frames.push_back({.seconds = point.seconds,
                      .x = point.pose.x,
                      .y = point.pose.y,
                      .angle = point.pose.heading});
  }
  svg.Group(frames, [&] {
    svg.Circle({0, 0}, state.radius, {.fill = "#3b5bdb"});
    svg.Line({0, 0}, {state.radius, 0}, {.stroke = "white", .width = 0.06});
  });
}

bool DrawRun(const CleaningState& state, const std::filesystem::path& file) {
  const double end = state.route.empty() ? 1 : state.route.back().seconds;
  Svg svg = Empty(state.plan, end);
  for (std::size_t tile = 0; tile < state.plan.size(); ++tile) {
    if (state.dirty[tile] != 0) DrawTile(svg, state.plan.TileOf(tile), kDirt);
  }
  for (std::size_t first = 0; first < state.swept.size();) {
    std::size_t last = first;
    const double until = state.swept[first].seconds;
    while (last < state.swept.size() && state.swept[last].seconds == until) ++last;
    svg.Shown(0, until, [&] {
      for (; first < last; ++first) {
        DrawTile(svg, state.plan.TileOf(state.swept[first].tile), kDirt);
      }
    });
  }
  DrawPlan(svg, state.plan);
  DrawBattery(svg, state);
  DrawRobot(svg, state);
  return svg.Save(file);
}

}  // namespace

std::vector<std::filesystem::path> DrawCleaning(const CleaningState& state,
                                                const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> written;
  const std::filesystem::path still = folder / "route.svg";
  const std::filesystem::path run = folder / "cleaning.svg";
  if (DrawRoute(state, still)) written.push_back(still);
  if (DrawRun(state, run)) written.push_back(run);
  return written;
}

}  // namespace latchwork::cleaning
