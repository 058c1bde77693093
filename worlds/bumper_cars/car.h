// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BUMPER_CARS_CAR_H_
#define LATCHWORK_BUMPER_CARS_CAR_H_

#include <cstdint>
#include <string>

#include "worlds/bumper_cars/geometry.h"

namespace latchwork::bumper_cars {

constexpr double kCarRadius = 0.55;  // m, of the rubber ring
constexpr double kCarMass = 250;     // kg, with its driver
constexpr double kMaxSpeed = 2.2;    // m/s, with the pedal down
constexpr double kMaxSteer = 1.0;    // rad
constexpr double kWeakPower = 0.3;   // of kMaxSpeed, when the charge is used up

/// What the one who drives it is to the agent.
enum class Attitude : std::uint8_t { kSelf, kEnemy, kFriend, kStranger };

struct Controls {
  double pedal =
      0;  ///< -1 to 1: the speed that the motor is to turn with, in parts of the highest.
  double steer = 0;  ///< rad, left > 0.
};

/// A bumper car: a disc with a rubber ring around it, a motor, and a wheel to steer with.
struct Car {
  std::string name;
  std::string driver;
  Attitude attitude = Attitude::kStranger;
  Vector place;
  double heading = 0;
  Vector velocity;  ///< In the frame of the arena; bumps push it to the side as well.
  double spin = 0;  ///< rad/s.
  double steer = 0;
  double charge = 0;  ///< s of driving with the pedal down that are left.
  double full_charge = 0;
  bool stalled = false;  ///< The motor does not turn at all.

  bool has_power() const { return charge > 0; }
  double forward_speed() const { return Dot(velocity, Along(heading)); }
};

/// Moves a car on by `seconds`. The motor pulls with limited force towards the speed that the pedal
/// asks for, slowly so when the charge is used up. The wheels roll along the heading: across it
/// they have a limited grip, and where that is not enough the car skids. The steered wheel turns at
/// a limited rate; how fast the car turns follows from its angle and the speed.
void Drive(const Controls& controls, double seconds, Car& car);

}  // namespace latchwork::bumper_cars

#endif  // LATCHWORK_BUMPER_CARS_CAR_H_
