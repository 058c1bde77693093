// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cart_pole/pole_dynamics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace latchwork::cart_pole {
namespace {

constexpr double kStep = 0.002;

Plant Frictionless() {
  Plant plant;
  plant.cart_friction = 0;
  plant.pivot_friction = 0;
  return plant;
}

Motion Later(const Plant& plant, Motion motion, double force, double seconds, double step = kStep) {
  const int steps = static_cast<int>(std::lround(seconds / step));
  for (int i = 0; i < steps; ++i) motion = Advance(plant, motion, force, step);
  return motion;
}

/// Seconds between the first two passages of the angle `middle` in the same direction.
double PeriodAround(const Plant& plant, Motion motion, double middle) {
  double first = -1;
  for (int i = 1; i < 10000; ++i) {
    const Motion next = Advance(plant, motion, 0, kStep);
    const double before = motion.angle - middle;
    const double after = next.angle - middle;
    motion = next;
    if (!(before < 0 && after >= 0)) continue;
    const double at = kStep * (i - after / (after - before));
    if (first >= 0) return at - first;
    first = at;
  }
  return -1;
}

TEST(PoleDynamicsTest, NoFriction_EnergyStays) {
  const Plant plant = Frictionless();
  const Motion start{.speed = 0.5, .angle = 0.3, .rate = -2};
  const double energy = Energy(plant, start);
  Motion motion = start;
  for (int second = 0; second < 60; ++second) {
    motion = Later(plant, motion, 0, 1);
    EXPECT_NEAR(Energy(plant, motion), energy, 1e-8);
  }
  EXPECT_GT(std::abs(motion.place), 1);
}

TEST(PoleDynamicsTest, Friction_TakesEnergyAndHangsThePoleDown) {
  const Plant plant{.cart_friction = 1, .pivot_friction = 0.01};
  Motion motion{.angle = 0.1};
  double energy = Energy(plant, motion);
  for (int second = 0; second < 20; ++second) {
    motion = Later(plant, motion, 0, 1);
    EXPECT_LT(Energy(plant, motion), energy);
    energy = Energy(plant, motion);
  }
  EXPECT_NEAR(std::cos(Later(plant, motion, 0, 60).angle), -1, 1e-3);
}

TEST(PoleDynamicsTest, NoFriction_MomentumStays_AForceChangesItByItsTime) {
  const Plant plant = Frictionless();
  const Motion start{.speed = 0.2, .angle = 0.4, .rate = 1};
  EXPECT_NEAR(Momentum(plant, Later(plant, start, 0, 5)), Momentum(plant, start), 1e-9);
  EXPECT_NEAR(Momentum(plant, Later(plant, start, 3, 2)), Momentum(plant, start) + 6, 1e-9);
}

TEST(PoleDynamicsTest, HangingPole_SwingsWithThePeriodOfTheLinearEquation) {
  const Plant plant = Frictionless();
  const double half = plant.pole_length / 2;
  const double total = plant.cart_mass + plant.pole_mass;
  const double factor = 4.0 / 3.0 - plant.pole_mass / total;
  const double period = 2 * std::numbers::pi * std::sqrt(half * factor / plant.gravity);
  const double down = std::numbers::pi;
  EXPECT_NEAR(PeriodAround(plant, {.angle = down - 0.01}, down), period, 1e-4 * period);
  // The wider the swing, the slower.
  EXPECT_GT(PeriodAround(plant, {.angle = down - 1.0}, down), 1.02 * period);
}

TEST(PoleDynamicsTest, HeavyCart_IsAPendulumOnAFixedPivot) {
  Plant plant = Frictionless();
  plant.cart_mass = 1e6;
  const double down = std::numbers::pi;
  const double period = 2 * down * std::sqrt(2 * plant.pole_length / (3 * plant.gravity));
  EXPECT_NEAR(PeriodAround(plant, {.angle = down - 0.01}, down), period, 1e-4 * period);
}

TEST(PoleDynamicsTest, Upright_FallsWithTheRateOfTheLinearEquation) {
  const Plant plant = Frictionless();
  const double half = plant.pole_length / 2;
  const double total = plant.cart_mass + plant.pole_mass;
  const double rate = std::sqrt(plant.gravity / (half * (4.0 / 3.0 - plant.pole_mass / total)));
  const Motion fallen = Later(plant, {.angle = 1e-6}, 0, 1);
  EXPECT_NEAR(fallen.angle, 1e-6 * std::cosh(rate), 1e-9);
  EXPECT_LT(fallen.place, 0);
  EXPECT_EQ(Later(plant, {}, 0, 1).angle, 0);
}

TEST(PoleDynamicsTest, HalfTheStep_ASixteenthOfTheError) {
  const Plant plant;
  const Motion start{.angle = 0.3, .rate = -1};
  const double exact = Later(plant, start, 2, 1, 1e-4).angle;
  const double coarse = std::abs(Later(plant, start, 2, 1, 0.04).angle - exact);
  const double fine = std::abs(Later(plant, start, 2, 1, 0.02).angle - exact);
  EXPECT_NEAR(coarse / fine, 16, 4);
}

TEST(PoleDynamicsTest, Mirrored_IsMirrored) {
  const Plant plant;
  const Motion right = Later(plant, {0.1, 0.2, 0.3, 0.4}, 1.5, 1);
  const Motion left = Later(plant, {-0.1, -0.2, -0.3, -0.4}, -1.5, 1);
  EXPECT_DOUBLE_EQ(right.place, -left.place);
  EXPECT_DOUBLE_EQ(right.angle, -left.angle);
}

TEST(StrikeTest, Blow_AddsItsMomentumAndMovesPlaces) {
  const Plant plant;
  const Motion start{.angle = 0.2, .rate = 0.5};
  for (const auto& [cart, tip] : {std::pair(0.5, 0.0), {0.0, 0.3}, {-0.2, 0.1}}) {
    const Motion struck = Strike(plant, start, cart, tip);
    EXPECT_NEAR(Momentum(plant, struck) - Momentum(plant, start), cart + tip, 1e-12);
    EXPECT_EQ(struck.angle, start.angle);
    EXPECT_EQ(struck.place, start.place);
  }
  EXPECT_LT(Strike(plant, {}, 0.5, 0).rate, 0);
  EXPECT_GT(Strike(plant, {}, 0, 0.1).rate, 0);
}

TEST(StrikeTest, Blow_IsAStrongShortForceOnTheCart) {
  const Plant plant = Frictionless();
  const Motion start{.angle = 0.2};
  const Motion struck = Strike(plant, start, 0.5, 0);
  const Motion pressed = Later(plant, start, 0.5e6, 1e-6, 1e-8);
  EXPECT_NEAR(struck.speed, pressed.speed, 1e-4);
  EXPECT_NEAR(struck.rate, pressed.rate, 1e-4);
}

}  // namespace
}  // namespace latchwork::cart_pole
