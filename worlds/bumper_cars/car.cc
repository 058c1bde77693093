// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/car.h"

#include <algorithm>

namespace latchwork::bumper_cars {
namespace {

constexpr double kMotorTime = 0.5;  // s, from a difference in speed to the pull that mends it
constexpr double kMaxPull = 2.5;    // m/s^2
constexpr double kRolling = 0.1;    // m/s^2, of a motor without a current
constexpr double kGrip = 5.0;       // m/s^2, of the wheels across
constexpr double kTurnGrip = 12.0;  // rad/s^2
constexpr double kSteerRate = 4.0;  // rad/s
constexpr double kWheelBase = 0.7;  // m

double Approach(double value, double goal, double step) {
  return value + std::clamp(goal - value, -step, step);
}

}  // namespace

void Drive(const Controls& controls, double seconds, Car& car) {
  const double pedal = std::clamp(controls.pedal, -1.0, 1.0);
  const Vector ahead = Along(car.heading);
  double along = Dot(car.velocity, ahead);
  double across = Dot(car.velocity, Left(ahead));

  if (car.stalled) {
    along = Approach(along, 0, kRolling * seconds);
  } else {
    const double wanted = pedal * kMaxSpeed * (car.has_power() ? 1.0 : kWeakPower);
    along += std::clamp((wanted - along) / kMotorTime, -kMaxPull, kMaxPull) * seconds;
    car.charge = std::max(0.0, car.charge - std::abs(pedal) * seconds);
  }
  across = Approach(across, 0, kGrip * seconds);

  const double steer = std::clamp(controls.steer, -kMaxSteer, kMaxSteer);
  car.steer = Approach(car.steer, steer, kSteerRate * seconds);
  const double spin = along * std::tan(car.steer) / kWheelBase;
  car.spin = Approach(car.spin, spin, kTurnGrip * seconds);

  car.velocity = along * ahead + across * Left(ahead);
  car.heading = WrapAngle(car.heading + car.spin * seconds);
  car.place = car.place + seconds * car.velocity;
}

}  // namespace latchwork::bumper_cars
