// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/driver.h"

#include <gtest/gtest.h>

#include <cmath>

namespace latchwork::traffic {
namespace {

TEST(DriverTest, NobodyAhead_AcceleratesUpToTheWantedSpeed) {
  const Driver driver;
  EXPECT_DOUBLE_EQ(FollowingAcceleration(driver, 0, {}), driver.acceleration);
  EXPECT_NEAR(FollowingAcceleration(driver, driver.wanted_speed, {}), 0, 1e-12);
  EXPECT_GE(FollowingAcceleration(driver, 2 * driver.wanted_speed, {}), -driver.braking);
}

TEST(DriverTest, EquilibriumGap_NeitherAcceleratesNorBrakes) {
  const Driver driver;
  for (const double speed : {1.0, 10.0, 20.0, 27.0}) {
    const double share = std::pow(speed / driver.wanted_speed, 4);
    const double gap = (driver.standstill_gap + speed * driver.headway) / std::sqrt(1 - share);
    EXPECT_NEAR(FollowingAcceleration(driver, speed, Leader{gap, speed}), 0, 1e-9);
    EXPECT_LT(FollowingAcceleration(driver, speed, Leader{gap - 1, speed}), 0);
    EXPECT_GT(FollowingAcceleration(driver, speed, Leader{gap + 1, speed}), 0);
  }
}

TEST(DriverTest, ClosingIn_BrakesWithinWhatTheBrakesGive) {
  const Driver driver;
  const double far = FollowingAcceleration(driver, 25, Leader{200, 0});
  const double near = FollowingAcceleration(driver, 25, Leader{40, 0});
  EXPECT_LT(near, far);
  EXPECT_EQ(FollowingAcceleration(driver, 25, Leader{0, 0}), -kHardestBraking);
}

TEST(GainTest, FasterLane_IsAGain_UnlessItMakesOthersBrake) {
  LaneChange change{.mine_now = -0.5, .mine_then = 1.0, .follower_now = 0, .follower_then = -0.5};
  EXPECT_DOUBLE_EQ(Gain(change, 0).value(), 1.3);
  EXPECT_DOUBLE_EQ(Gain(change, 1).value(), 0.8);
  change.follower_then = -4;
  EXPECT_FALSE(Gain(change, 0));
}

}  // namespace
}  // namespace latchwork::traffic
