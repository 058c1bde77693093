// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/driver.h"

#include <algorithm>
#include <cmath>

namespace latchwork::traffic {

namespace {

constexpr double kSafeBraking = 3.0;  // m/s^2 that a change may cost whoever is behind
constexpr double kThreshold = 0.2;    // m/s^2 below which a change is not worth its while

}  // namespace

double FollowingAcceleration(const Driver& driver, double speed,
                             const std::optional<Leader>& leader) {
  const double share = speed / driver.wanted_speed;
  double free = driver.acceleration * (1.0 - share * share * share * share);
  free = std::max(free, -driver.braking);
  if (!leader) return free;
  const double closing = speed - leader->speed;
  const double root = 2.0 * std::sqrt(driver.acceleration * driver.braking);
  const double wanted =
      driver.standstill_gap + std::max(0.0, speed * driver.headway + speed * closing / root);
  const double ratio = wanted / std::max(leader->gap, 0.1);
  return std::max(free - driver.acceleration * ratio * ratio, -kHardestBraking);
}

std::optional<double> Gain(const LaneChange& change, double politeness) {
  if (change.follower_then < -kSafeBraking) return std::nullopt;
  const double others = change.follower_then - change.follower_now;
  return change.mine_then - change.mine_now + politeness * others + change.bias - kThreshold;
}

}  // namespace latchwork::traffic
