// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TRAFFIC_CAR_H_
#define LATCHWORK_TRAFFIC_CAR_H_

#include <cmath>
#include <cstdint>

#include "latchwork/logic/symbol.h"

namespace latchwork::traffic {

inline constexpr double kLaneWidth = 3.5;       // m
inline constexpr double kHardestBraking = 8.0;  // m/s^2

/// How somebody drives, by the intelligent driver model and MOBIL (driver.h).
struct Driver {
  double wanted_speed = 28.0;   ///< m/s
  double headway = 1.3;         ///< s
  double standstill_gap = 2.0;  ///< m
  double acceleration = 1.4;    ///< m/s^2
  double braking = 2.0;         ///< m/s^2, comfortable
  double politeness = 0.3;      ///< How much of others' acceleration a change of lane is worth.
};

/// A car or truck. Its place is that of its centre: `s` along the road, `y` across it from the
/// middle of lane 0, the rightmost, to the left.
struct Car {
  logic::Symbol name;
  double length = 4.5;      ///< m
  double width = 1.8;       ///< m
  double s = 0;             ///< m
  double y = 0;             ///< m
  double speed = 0;         ///< m/s
  double acceleration = 0;  ///< m/s^2
  double side_speed = 0;    ///< m/s, to the left
  int aim = 0;              ///< The lane that it steers for.
  Driver driver;
  std::uint64_t may_change_at = 0;  ///< tick
  std::uint64_t brakes_until = 0;   ///< tick

  /// The lane whose middle is nearest; may be one that does not exist.
  int lane() const;
  /// Whether it takes up room in a lane, or is about to.
  bool Occupies(int lane) const {
    return aim == lane || std::abs(y - lane * kLaneWidth) < (kLaneWidth + width) / 2;
  }
  /// Whether it drives along the middle of the lane that it aims for.
  bool settled() const;
};

/// Moves a car on: the engine and the brakes follow `command` (m/s^2) with a lag of 0.2 s, the
/// engine gives 3 m/s^2 at most and less at speed, the brakes 8; it never rolls back. Steering
/// crosses a lane in about 4 s: at most 1.2 m/s sideways, 1 m/s^2 in getting there, and never
/// sideways faster than 0.3 of the speed.
void Move(Car& car, double command, double dt);

}  // namespace latchwork::traffic

#endif  // LATCHWORK_TRAFFIC_CAR_H_
