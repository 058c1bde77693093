// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TRAFFIC_REWARD_H_
#define LATCHWORK_TRAFFIC_REWARD_H_

#include <optional>

namespace latchwork::traffic {

/// What a moment of driving is judged by.
struct Moment {
  double speed = 0;               ///< m/s
  double speed_limit = 30;        ///< m/s
  double acceleration = 0;        ///< m/s^2
  double side_speed = 0;          ///< m/s
  std::optional<double> headway;  ///< s to the car ahead; nothing: nobody near
  double follower_braking = 0;    ///< m/s^2 that whoever is behind brakes with
};

inline constexpr double kArrivedReward = 10;
inline constexpr double kMissedReward = -30;
inline constexpr double kCollisionReward = -100;

/// Reward per second: progress (1 at the speed limit) less the discomfort of braking, accelerating
/// and swerving, of tailgating (a headway below 0.8 s), of speeding, and of making others brake.
double RewardRate(const Moment& moment);

}  // namespace latchwork::traffic

#endif  // LATCHWORK_TRAFFIC_REWARD_H_
