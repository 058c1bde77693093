// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_PICTURE_H_
#define LATCHWORK_OFFICE_PICTURE_H_

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "worlds/office/boxes.h"
#include "worlds/office/building.h"

namespace latchwork::office {

struct RoutePoint {
  int floor = 0;
  Point place;
  std::uint64_t tick = 0;
};

/// Something worth a label.
struct Remark {
  std::uint64_t tick = 0;
  int floor = 0;
  Point place;
  std::string text;
};

/// What happened in a run, for its pictures.
struct Record {
  std::vector<RoutePoint> route;
  std::vector<RoutePoint> people;
  std::vector<Box> boxes;
  std::vector<Remark> remarks;
};

struct PictureScene {
  const Building* building = nullptr;
  const Record* record = nullptr;
  std::vector<char> shut_doors;  ///< By door.
  double tick_seconds = 0.1;
  int goal_floor = -1;  ///< -1: no goal.
  Point goal;
};

/// One PNG for each floor, drawn without a display: "floor1.png". Returns what could be written.
std::vector<std::filesystem::path> DrawFloors(const PictureScene& scene,
                                              const std::filesystem::path& folder);

/// All floors in one SVG, "route.svg". Returns what could be written.
std::vector<std::filesystem::path> DrawRoute(const PictureScene& scene,
                                             const std::filesystem::path& folder);

/// The floors as they stand, without what happened, to draw the ways of many runs over: for each
/// "plan1.svg", in one colour that the page decides. Returns what could be written.
std::vector<std::filesystem::path> DrawPlans(const PictureScene& scene,
                                             const std::filesystem::path& folder);

/// Colour of a moment of the run, 0 at its start, 1 at its end: blue, teal, green, yellow, red.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};
Colour ColourOfTime(double t);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_PICTURE_H_
