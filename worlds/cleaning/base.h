// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CLEANING_BASE_H_
#define LATCHWORK_CLEANING_BASE_H_

#include <optional>

#include "worlds/cleaning/floor_plan.h"

namespace latchwork::cleaning {

struct Pose {
  double x = 0;
  double y = 0;
  double heading = 0;  ///< rad, counter-clockwise from east, in (-pi, pi].
};

/// Maps an angle to (-pi, pi].
double WrapAngle(double angle);

/// Sizes and limits of the robot.
struct BaseLimits {
  double radius = 0.3;             ///< m
  double max_speed = 0.5;          ///< m/s, forwards and backwards
  double acceleration = 1.0;       ///< m/s2
  double max_turn_rate = 2.0;      ///< rad/s
  double turn_acceleration = 8.0;  ///< rad/s2
};

/// A round robot on two driven wheels. Speed and turn rate follow what it is told as fast as its
/// motors let them, and it moves along arcs. Where its rim touches something it stops.
class Base {
 public:
  explicit Base(const BaseLimits& limits) : limits_(limits) {}

  void Place(const Pose& pose) { pose_ = pose; }
  /// What to do from now on; beyond the limits: as fast as it can.
  void Drive(double speed, double turn_rate);
  /// Moves for `dt` seconds. The direction from its middle to what it ran into, relative to its
  /// heading, when something stopped it.
  std::optional<double> Step(double dt, const FloorPlan& plan);

  const Pose& pose() const { return pose_; }
  Point place() const { return {pose_.x, pose_.y}; }
  double speed() const { return speed_; }
  double turn_rate() const { return turn_rate_; }
  double travelled() const { return travelled_; }  ///< m

 private:
  std::optional<double> ContactAt(Point place, const FloorPlan& plan) const;

  BaseLimits limits_;
  Pose pose_;
  double speed_ = 0;
  double turn_rate_ = 0;
  double wanted_speed_ = 0;
  double wanted_turn_rate_ = 0;
  double travelled_ = 0;
};

}  // namespace latchwork::cleaning

#endif  // LATCHWORK_CLEANING_BASE_H_
