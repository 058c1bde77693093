// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/car.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace latchwork::bumper_cars {
namespace {

Car Charged() {
  Car car;
  car.charge = car.full_charge = 60;
  return car;
}

void DriveFor(double seconds, const Controls& controls, Car& car) {
  for (int i = 0; i < static_cast<int>(seconds * 100 + 0.5); ++i) Drive(controls, 0.01, car);
}

TEST(CarTest, PedalDown_ReachesTheHighestSpeedAndNoMore) {
  Car car = Charged();
  DriveFor(0.2, {1, 0}, car);
  EXPECT_NEAR(car.forward_speed(), 0.5, 0.01);  // limited pull
  DriveFor(8, {1, 0}, car);
  EXPECT_NEAR(car.forward_speed(), kMaxSpeed, 0.01);
  EXPECT_NEAR(car.place.y, 0, 1e-9);
}

TEST(CarTest, HalfThePedal_HalfTheSpeed) {
  Car car = Charged();
  DriveFor(8, {0.5, 0}, car);
  EXPECT_NEAR(car.forward_speed(), kMaxSpeed / 2, 0.01);
}

TEST(CarTest, ChargeUsedUp_MotorIsWeak) {
  Car car = Charged();
  car.charge = 0.5;
  DriveFor(8, {1, 0}, car);
  EXPECT_FALSE(car.has_power());
  EXPECT_NEAR(car.forward_speed(), kWeakPower * kMaxSpeed, 0.01);
}

TEST(CarTest, Charge_IsUsedAsThePedalIsPressed) {
  Car car = Charged();
  DriveFor(10, {-0.5, 0}, car);
  EXPECT_NEAR(car.charge, 55, 1e-6);
}

TEST(CarTest, StalledCar_RollsOut) {
  Car car = Charged();
  car.stalled = true;
  car.velocity = {0.5, 0};
  DriveFor(6, {1, 0}, car);
  EXPECT_EQ(car.velocity, Vector{});
}

TEST(CarTest, Steering_TurnsOnTheCircleOfItsAngle) {
  Car car = Charged();
  DriveFor(20, {0.3, 0.5}, car);
  const double radius = car.forward_speed() / car.spin;
  EXPECT_NEAR(radius, 0.7 / std::tan(0.5), 0.02);
}

TEST(CarTest, Steering_IsLimited) {
  Car one = Charged();
  Car other = Charged();
  DriveFor(3, {0.3, kMaxSteer}, one);
  DriveFor(3, {0.3, 50}, other);
  EXPECT_EQ(one.place, other.place);
}

TEST(CarTest, Reverse_TurnsTheOtherWay) {
  Car car = Charged();
  DriveFor(2, {-0.3, 0.5}, car);
  EXPECT_LT(car.forward_speed(), 0);
  EXPECT_LT(car.spin, 0);
}

TEST(CarTest, PushedToTheSide_SkidsToAStop) {
  Car car = Charged();
  car.velocity = {0, 1};
  DriveFor(0.1, {}, car);
  EXPECT_NEAR(car.velocity.y, 0.5, 1e-9);
  DriveFor(0.2, {}, car);
  EXPECT_NEAR(car.velocity.y, 0, 1e-9);
}

}  // namespace
}  // namespace latchwork::bumper_cars
