// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TRAFFIC_DRIVER_H_
#define LATCHWORK_TRAFFIC_DRIVER_H_

#include <optional>

#include "worlds/traffic/car.h"

namespace latchwork::traffic {

/// What a driver sees of the car before it.
struct Leader {
  double gap = 0;    ///< m, from bumper to bumper
  double speed = 0;  ///< m/s
};

/// The intelligent driver model: the acceleration (m/s^2) with which a driver at a speed follows a
/// leader, or nobody. Never harder than the brakes allow. Source: Treiber, Hennecke and Helbing,
/// "Congested traffic states in empirical observations and microscopic simulations" (2000).
double FollowingAcceleration(const Driver& driver, double speed,
                             const std::optional<Leader>& leader);

/// What a change of lane would do, in accelerations (m/s^2).
struct LaneChange {
  double mine_now = 0;
  double mine_then = 0;
  double follower_now = 0;  ///< Of whoever would be behind.
  double follower_then = 0;
  double bias = 0;  ///< In favour of the change: back to the right.
};

/// MOBIL: what a driver gains by the change; nothing where whoever would be behind had to brake
/// hard. Source: Kesting, Treiber and Helbing, "General lane-changing model MOBIL for car-following
/// models" (2007).
std::optional<double> Gain(const LaneChange& change, double politeness);

}  // namespace latchwork::traffic

#endif  // LATCHWORK_TRAFFIC_DRIVER_H_
