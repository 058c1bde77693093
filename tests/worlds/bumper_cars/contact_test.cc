// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/contact.h"

#include <gtest/gtest.h>

#include "latchwork/sdk/random.h"
#include "worlds/bumper_cars/arena.h"

namespace latchwork::bumper_cars {
namespace {

Car At(Vector place, Vector velocity) {
  Car car;
  car.place = place;
  car.velocity = velocity;
  return car;
}

double Energy(const Car& car) {
  const double inertia = 0.5 * kCarMass * kCarRadius * kCarRadius;
  return 0.5 * kCarMass * Dot(car.velocity, car.velocity) + 0.5 * inertia * car.spin * car.spin;
}

TEST(ContactTest, CarsApart_DoNotCollide) {
  Car a = At({0, 0}, {1, 0});
  Car b = At({2 * kCarRadius + 0.001, 0}, {});
  EXPECT_FALSE(Collide(a, b).has_value());
}

TEST(ContactTest, CarsThatMoveApart_ArePushedApartOnly) {
  Car a = At({0, 0}, {-1, 0});
  Car b = At({1, 0}, {});
  EXPECT_FALSE(Collide(a, b).has_value());
  EXPECT_NEAR(Length(b.place - a.place), 2 * kCarRadius, 1e-12);
  EXPECT_EQ(a.velocity, (Vector{-1, 0}));
}

TEST(ContactTest, HeadOn_ExchangesMomentumByRestitution) {
  Car a = At({0, 0}, {2, 0});
  Car b = At({1, 0}, {});
  const auto impact = Collide(a, b);
  ASSERT_TRUE(impact.has_value());
  EXPECT_DOUBLE_EQ(impact->closing, 2);
  EXPECT_DOUBLE_EQ(impact->first, 2);
  EXPECT_DOUBLE_EQ(impact->second, 0);
  const double e = Restitution(2);
  EXPECT_NEAR(b.velocity.x - a.velocity.x, 2 * e, 1e-12);
  EXPECT_NEAR(a.velocity.x + b.velocity.x, 2, 1e-12);
}

TEST(ContactTest, HitFromBehind_SpeedsAreThoseOfEach) {
  Car a = At({0, 0}, {2, 0});
  Car b = At({1, 0}, {0.5, 0});
  const auto impact = Collide(a, b);
  ASSERT_TRUE(impact.has_value());
  EXPECT_DOUBLE_EQ(impact->closing, 1.5);
  EXPECT_DOUBLE_EQ(impact->first, 2);
  EXPECT_DOUBLE_EQ(impact->second, 0);
}

TEST(ContactTest, Restitution_FallsWithTheSpeed) {
  EXPECT_DOUBLE_EQ(Restitution(0.1), Restitution(0.5));
  EXPECT_NEAR(Restitution(8), Restitution(0.5) / 2, 1e-12);
}

TEST(ContactTest, AnyCollision_KeepsMomentumAndLosesEnergy) {
  const sdk::RandomStream random(7, "contact");
  for (std::uint64_t i = 0; i < 500; ++i) {
    const auto number = [&](std::uint64_t j) { return random.Between(-2, 2, i, j); };
    Car a = At({0, 0}, {number(0), number(1)});
    Car b = At({0.5 * number(2), 0.5 * number(3)}, {number(4), number(5)});
    a.spin = number(6);
    b.spin = number(7);
    const double inertia = 0.5 * kCarMass * kCarRadius * kCarRadius;
    const auto turning = [&](const Car& car) {
      return kCarMass * (car.place.x * car.velocity.y - car.place.y * car.velocity.x) +
             inertia * car.spin;
    };
    const Vector momentum = a.velocity + b.velocity;
    const double energy = Energy(a) + Energy(b);
    // The cars are pushed apart first, so that what turns is compared where they are then.
    Car a_then = a;
    Car b_then = b;
    if (!Collide(a, b)) continue;
    a_then.place = a.place;
    b_then.place = b.place;
    EXPECT_NEAR((a.velocity + b.velocity).x, momentum.x, 1e-9);
    EXPECT_NEAR((a.velocity + b.velocity).y, momentum.y, 1e-9);
    EXPECT_NEAR(turning(a) + turning(b), turning(a_then) + turning(b_then), 1e-6);
    EXPECT_LT(Energy(a) + Energy(b), energy + 1e-9);
  }
}

TEST(ContactTest, Post_ThrowsTheCarBack) {
  Car car = At({0, 0}, {1, 0});
  const auto impact = CollideWithPost({0.6, 0}, 0.15, car);
  ASSERT_TRUE(impact.has_value());
  EXPECT_NEAR(car.velocity.x, -Restitution(1), 1e-12);
  EXPECT_NEAR(car.place.x, 0.6 - 0.15 - kCarRadius, 1e-12);
}

TEST(ContactTest, Walls_KeepTheCarIn) {
  Car car = At({0.4, 9.8}, {-1, 1});
  EXPECT_TRUE(CollideWithWalls({16, 10}, car).has_value());
  EXPECT_GT(car.velocity.x, 0);
  EXPECT_LT(car.velocity.y, 0);
  EXPECT_NEAR(car.place.x, kCarRadius, 1e-12);
  EXPECT_NEAR(car.place.y, 10 - kCarRadius, 1e-12);
}

TEST(ArenaTest, ClearAhead_SeesWallsAndPoles) {
  Arena arena{.size = {16, 10}, .gate = {}, .poles = {{"pole1", {8, 5}}}, .cars = {}};
  Car car = At({4, 5}, {});
  EXPECT_NEAR(arena.ClearAhead(car, 0), 4 - kPoleRadius - kCarRadius, 1e-12);
  car.heading = 1.5707963267948966;
  EXPECT_NEAR(arena.ClearAhead(car, 0), 5 - kCarRadius, 1e-9);
}

TEST(ArenaTest, Pole_ChargesTheCarThatTouchesIt) {
  Arena arena{.size = {16, 10}, .gate = {}, .poles = {{"pole1", {8, 5}}}, .cars = {At({6, 5}, {})}};
  arena.cars[0].full_charge = 30;
  const std::vector<Controls> controls{{1, 0}};
  for (int i = 0; i < 10; ++i) arena.Step(controls, 0.1);
  EXPECT_EQ(arena.cars[0].charge, 0);
  for (int i = 0; i < 30; ++i) arena.Step(controls, 0.1);
  EXPECT_GT(arena.cars[0].charge, 25);
}

TEST(ArenaTest, CarsNeverLeaveNorOverlapMuch) {
  Arena arena{.size = {6, 6}, .gate = {}, .poles = {{"pole1", {3, 3}}}, .cars = {}};
  const sdk::RandomStream random(3, "cars");
  for (const Vector place : {Vector{1, 1}, Vector{5, 1}, Vector{1, 5}, Vector{5, 5}}) {
    arena.cars.push_back(At(place, {}));
    arena.cars.back().charge = arena.cars.back().full_charge = 1000;
  }
  std::vector<Controls> controls(4);
  for (std::uint64_t tick = 0; tick < 1000; ++tick) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (tick % 20 == 0) {
        controls[i] = {random.Between(-1, 1, tick, 2 * i), random.Between(-1, 1, tick, 2 * i + 1)};
      }
    }
    arena.Step(controls, 0.1);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector place = arena.cars[i].place;
      EXPECT_GT(place.x, kCarRadius - 0.05);
      EXPECT_LT(place.y, 6 - kCarRadius + 0.05);
      for (std::size_t j = i + 1; j < 4; ++j) {
        EXPECT_GT(Length(arena.cars[j].place - place), 2 * kCarRadius - 0.15);
      }
    }
  }
}

}  // namespace
}  // namespace latchwork::bumper_cars
