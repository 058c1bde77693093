// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/reward.h"

#include <algorithm>

namespace latchwork::traffic {

namespace {

constexpr double kForce = 0.03;        // per (m/s^2)^2
constexpr double kSwerving = 0.1;      // per (m/s)^2
constexpr double kTailgating = 1.0;    // at a headway of 0
constexpr double kShortHeadway = 0.8;  // s
constexpr double kSpeeding = 10.0;     // per share above 1.05 of the limit
constexpr double kImposing = 0.3;      // per m/s^2 that others brake harder than 2

}  // namespace

double RewardRate(const Moment& moment) {
  const double share = moment.speed / moment.speed_limit;
  double rate = std::min(share, 1.0);
  rate -= kSpeeding * std::max(0.0, share - 1.05);
  rate -= kForce * moment.acceleration * moment.acceleration;
  rate -= kSwerving * moment.side_speed * moment.side_speed;
  if (moment.headway) {
    rate -= kTailgating * std::max(0.0, 1.0 - *moment.headway / kShortHeadway);
  }
  return rate - kImposing * std::max(0.0, moment.follower_braking - 2.0);
}

}  // namespace latchwork::traffic
