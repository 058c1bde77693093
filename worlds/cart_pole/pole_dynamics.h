// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CART_POLE_POLE_DYNAMICS_H_
#define LATCHWORK_CART_POLE_POLE_DYNAMICS_H_

namespace latchwork::cart_pole {

/// A uniform rod that turns freely on a cart.
struct Plant {
  double cart_mass = 1.0;        ///< kg
  double pole_mass = 0.1;        ///< kg
  double pole_length = 1.0;      ///< m
  double cart_friction = 0.1;    ///< N per m/s
  double pivot_friction = 1e-4;  ///< N m per rad/s
  double gravity = 9.81;         ///< m/s^2
};

struct Motion {
  double place = 0;  ///< m, of the cart, to the right
  double speed = 0;  ///< m/s
  double angle = 0;  ///< rad, of the pole from upright, leaning to the right > 0
  double rate = 0;   ///< rad/s
};

/// Moves on by `dt` seconds under a constant horizontal force (N) on the cart, by one step of the
/// classic Runge-Kutta method. Source: the full nonlinear equations of cart and pole (Barto, Sutton
/// and Anderson 1983) with the corrected reaction of the pole (Florian 2007); friction is viscous.
Motion Advance(const Plant& plant, const Motion& motion, double force, double dt);

/// Kinetic and potential energy (J); the pole's lies at 0 when it is level.
double Energy(const Plant& plant, const Motion& motion);
/// Horizontal momentum (N s).
double Momentum(const Plant& plant, const Motion& motion);

/// What short horizontal blows (N s, to the right) against the cart and against the pole's tip do.
Motion Strike(const Plant& plant, const Motion& motion, double cart, double tip);

}  // namespace latchwork::cart_pole

#endif  // LATCHWORK_CART_POLE_POLE_DYNAMICS_H_
