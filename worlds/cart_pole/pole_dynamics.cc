// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cart_pole/pole_dynamics.h"

#include <cmath>

namespace latchwork::cart_pole {

namespace {

struct Change {
  double speed = 0;
  double acceleration = 0;
  double rate = 0;
  double turning = 0;
};

Change ChangeOf(const Plant& plant, const Motion& motion, double force) {
  const double half = plant.pole_length / 2;
  const double total = plant.cart_mass + plant.pole_mass;
  const double moment = plant.pole_mass * half;
  const double sine = std::sin(motion.angle);
  const double cosine = std::cos(motion.angle);
  const double drive =
      (force - plant.cart_friction * motion.speed + moment * motion.rate * motion.rate * sine) /
      total;
  const double turning =
      (plant.gravity * sine - cosine * drive - plant.pivot_friction * motion.rate / moment) /
      (half * (4.0 / 3.0 - plant.pole_mass * cosine * cosine / total));
  return {motion.speed, drive - moment * turning * cosine / total, motion.rate, turning};
}

Motion Plus(const Motion& motion, const Change& change, double dt) {
  return {motion.place + dt * change.speed, motion.speed + dt * change.acceleration,
          motion.angle + dt * change.rate, motion.rate + dt * change.turning};
}

}  // namespace

Motion Advance(const Plant& plant, const Motion& motion, double force, double dt) {
  const Change a = ChangeOf(plant, motion, force);
  const Change b = ChangeOf(plant, Plus(motion, a, dt / 2), force);
  const Change c = ChangeOf(plant, Plus(motion, b, dt / 2), force);
  const Change d = ChangeOf(plant, Plus(motion, c, dt), force);
  const Change mean{(a.speed + 2 * b.speed + 2 * c.speed + d.speed) / 6,
                    (a.acceleration + 2 * b.acceleration + 2 * c.acceleration + d.acceleration) / 6,
                    (a.rate + 2 * b.rate + 2 * c.rate + d.rate) / 6,
                    (a.turning + 2 * b.turning + 2 * c.turning + d.turning) / 6};
  return Plus(motion, mean, dt);
}

double Energy(const Plant& plant, const Motion& motion) {
  const double half = plant.pole_length / 2;
  const double total = plant.cart_mass + plant.pole_mass;
  const double cosine = std::cos(motion.angle);
  const double inertia = 4.0 / 3.0 * plant.pole_mass * half * half;
  return total * motion.speed * motion.speed / 2 +
         plant.pole_mass * half * motion.speed * motion.rate * cosine +
         inertia * motion.rate * motion.rate / 2 + plant.pole_mass * plant.gravity * half * cosine;
}

double Momentum(const Plant& plant, const Motion& motion) {
  return (plant.cart_mass + plant.pole_mass) * motion.speed +
         plant.pole_mass * plant.pole_length / 2 * motion.rate * std::cos(motion.angle);
}

Motion Strike(const Plant& plant, const Motion& motion, double cart, double tip) {
  const double half = plant.pole_length / 2;
  const double total = plant.cart_mass + plant.pole_mass;
  const double inertia = 4.0 / 3.0 * plant.pole_mass * half * half;
  const double coupling = plant.pole_mass * half * std::cos(motion.angle);
  const double push = cart + tip;
  const double twist = tip * plant.pole_length * std::cos(motion.angle);
  const double determinant = total * inertia - coupling * coupling;
  Motion struck = motion;
  struck.speed += (inertia * push - coupling * twist) / determinant;
  struck.rate += (total * twist - coupling * push) / determinant;
  return struck;
}

}  // namespace latchwork::cart_pole
