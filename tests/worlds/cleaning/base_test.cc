// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cleaning/base.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/worlds/cleaning/cleaning_fixture.h"
#include "worlds/cleaning/battery.h"

namespace latchwork::cleaning {
namespace {

class BaseTest : public ::testing::Test {
 protected:
  BaseTest() {
    logic::Diagnostics diagnostics;
    plan_ = ReadFloorPlan(kRoom, "room", diagnostics);
  }
  FloorPlan plan_;
  Base base_{BaseLimits{}};
};

TEST_F(BaseTest, Speed_KeepsWithinItsAcceleration) {
  base_.Place({1, 1.25, 0});
  base_.Drive(9, 0);
  EXPECT_FALSE(base_.Step(0.1, plan_));
  EXPECT_NEAR(base_.speed(), 0.1, 1e-12);
  for (int i = 0; i < 10; ++i) base_.Step(0.1, plan_);
  EXPECT_NEAR(base_.speed(), 0.5, 1e-12);
}

TEST_F(BaseTest, DrivesIntoWall_StopsAtContactAhead) {
  base_.Place({1, 1.25, std::numbers::pi});
  base_.Drive(0.5, 0);
  std::optional<double> contact;
  for (int i = 0; i < 40 && !contact; ++i) contact = base_.Step(0.1, plan_);
  ASSERT_TRUE(contact);
  EXPECT_NEAR(*contact, 0, 1e-9);
  EXPECT_EQ(base_.speed(), 0);
  EXPECT_GE(base_.pose().x, kTile + 0.3);
  EXPECT_LT(base_.pose().x, kTile + 0.32);
}

TEST_F(BaseTest, BacksIntoWall_FeelsItBehind) {
  base_.Place({1, 1.25, 0});
  base_.Drive(-0.5, 0);
  std::optional<double> contact;
  for (int i = 0; i < 40 && !contact; ++i) contact = base_.Step(0.1, plan_);
  ASSERT_TRUE(contact);
  EXPECT_NEAR(std::abs(*contact), std::numbers::pi, 1e-9);
}

TEST_F(BaseTest, SpeedAndTurn_MakeACircle) {
  base_.Place({1.5, 0.75, 0});
  base_.Drive(0.2, 0.5);
  for (int i = 0; i < 40; ++i) base_.Step(0.1, plan_);
  const double radius = 0.4;
  const Pose start = base_.pose();
  const Point middle{start.x - radius * std::sin(start.heading),
                     start.y + radius * std::cos(start.heading)};
  for (int i = 0; i < 30; ++i) {
    ASSERT_FALSE(base_.Step(0.1, plan_));
    const Pose& now = base_.pose();
    EXPECT_NEAR(std::hypot(now.x - middle.x, now.y - middle.y), radius, 1e-9);
  }
}

TEST_F(BaseTest, TurnsOnTheSpot_EvenAtAWall) {
  base_.Place({kTile + 0.3, 1.25, 0});
  base_.Drive(0, 2);
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(base_.Step(0.1, plan_));
  EXPECT_GT(base_.pose().heading, 1);
  EXPECT_EQ(base_.travelled(), 0);
}

TEST(BatteryTest, Drains_ByWhatItDoes) {
  Battery battery({.capacity = 1000});
  battery.Step(1, 0.5, false);
  EXPECT_NEAR(battery.charge(), 1 - 0.05, 1e-12) << "8 + 22 + 40 * 0.5 = 50 W";
  for (int i = 0; i < 30; ++i) battery.Step(1, 0.5, false);
  EXPECT_TRUE(battery.is_empty());
  EXPECT_EQ(battery.lowest_charge(), 0);
}

TEST(BatteryTest, Dock_FillsItAndNoMore) {
  Battery battery({.capacity = 1000, .dock_power = 180});
  battery.Step(10, 0, false);
  EXPECT_NEAR(battery.charge(), 0.7, 1e-12);
  battery.Step(1, 0, true);
  EXPECT_NEAR(battery.charge(), 0.872, 1e-12);
  battery.Step(10, 0, true);
  EXPECT_EQ(battery.charge(), 1);
  EXPECT_NEAR(battery.lowest_charge(), 0.7, 1e-12);
}

}  // namespace
}  // namespace latchwork::cleaning
