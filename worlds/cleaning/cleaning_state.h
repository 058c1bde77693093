// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CLEANING_CLEANING_STATE_H_
#define LATCHWORK_CLEANING_CLEANING_STATE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "worlds/cleaning/base.h"
#include "worlds/cleaning/battery.h"
#include "worlds/cleaning/floor_plan.h"

namespace latchwork::cleaning {

/// Half the diameter of the dock's mat, m: the robot's middle is over it.
inline constexpr double kDockRadius = 0.15;

/// A place on the robot's way, for the drawing.
struct RoutePoint {
  double seconds = 0;
  Pose pose;
  double charge = 0;
};

/// When a tile became clean.
struct Swept {
  double seconds = 0;
  std::size_t tile = 0;
};

/// What a run changes.
struct CleaningState {
  CleaningState(FloorPlan floor, const BaseLimits& limits, const BatteryOptions& options)
      : plan(std::move(floor)), base(limits), battery(options) {}

  /// Everything but what stands on the floor becomes dirty; the robot stands on its dock.
  void Begin(double heading, double radius, double brush_radius);
  /// Puts a box of 2 x 2 tiles to the north-east of this one; what is in reach changes.
  void PutBox(Tile corner);
  /// Whether all four tiles are floor and neither the dock nor the robot is there.
  bool HasRoomForBox(Tile corner) const;
  void Sweep(double seconds);
  void Spill(Point place, double radius);
  bool IsDocked() const;
  /// Clean part of the tiles in reach.
  double CleanPart() const;

  FloorPlan plan;
  Base base;
  Battery battery;
  double radius = 0;
  double brush = 0;
  std::vector<char> in_reach;
  std::vector<char> dirty;
  std::size_t tiles_in_reach = 0;
  std::optional<double> contact;  ///< Of the last tick.
  std::vector<RoutePoint> route;
  std::vector<Swept> swept;
};

}  // namespace latchwork::cleaning

#endif  // LATCHWORK_CLEANING_CLEANING_STATE_H_
