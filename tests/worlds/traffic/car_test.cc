// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/car.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace latchwork::traffic {
namespace {

constexpr double kTick = 0.1;

TEST(CarTest, FullBraking_StopsInTheDistanceOfPhysicsAndLag) {
  Car car;
  car.speed = 30;
  for (int i = 0; i < 100; ++i) Move(car, -100, kTick);
  EXPECT_EQ(car.speed, 0);
  const double braking = 30.0 * 30.0 / (2 * kHardestBraking);
  EXPECT_GT(car.s, braking);
  EXPECT_LT(car.s, braking + 30 * 0.25);
}

TEST(CarTest, BrakingAtAStand_NeverRollsBack) {
  Car car;
  for (int i = 0; i < 20; ++i) Move(car, -5, kTick);
  EXPECT_EQ(car.s, 0);
  EXPECT_EQ(car.acceleration, 0);
}

TEST(CarTest, FullPower_ReachesTheTopSpeedAndNoMore) {
  Car car;
  for (int i = 0; i < 3000; ++i) Move(car, 100, kTick);
  EXPECT_GT(car.speed, 50);
  EXPECT_LE(car.speed, 55);
}

TEST(CarTest, ConstantCommand_CoversHalfAccelerationTimesTimeSquared) {
  Car car;
  for (int i = 0; i < 100; ++i) Move(car, 1, 0.01);
  EXPECT_NEAR(car.s, 0.5, 0.2);  // the lag of 0.2 s costs 0.16 m
  EXPECT_LT(car.s, 0.5);
}

TEST(CarTest, ChangeOfLane_TakesAboutFourSecondsAndDoesNotOvershoot) {
  Car car;
  car.speed = 25;
  car.aim = 1;
  double furthest = 0;
  double fastest = 0;
  int ticks = 0;
  for (int i = 0; i < 100; ++i) {
    Move(car, 0, kTick);
    furthest = std::max(furthest, car.y);
    fastest = std::max(fastest, std::abs(car.side_speed));
    if (car.y < 0.99 * kLaneWidth) ++ticks;
  }
  EXPECT_GE(ticks, 30);
  EXPECT_LE(ticks, 55);
  EXPECT_NEAR(car.y, kLaneWidth, 0.01);
  EXPECT_LT(furthest, kLaneWidth + 0.1);
  EXPECT_LE(fastest, 1.2 + 1e-9);
}

TEST(CarTest, Standing_CannotMoveSideways) {
  Car car;
  car.aim = 1;
  for (int i = 0; i < 50; ++i) Move(car, 0, kTick);
  EXPECT_EQ(car.y, 0);
}

TEST(CarTest, BetweenLanes_OccupiesBoth) {
  Car car;
  EXPECT_TRUE(car.Occupies(0));
  EXPECT_FALSE(car.Occupies(1));
  car.aim = 1;
  EXPECT_TRUE(car.Occupies(1));
  car.y = 1.5;
  EXPECT_TRUE(car.Occupies(0));
  car.y = kLaneWidth;
  EXPECT_FALSE(car.Occupies(0));
  EXPECT_EQ(car.lane(), 1);
}

}  // namespace
}  // namespace latchwork::traffic
