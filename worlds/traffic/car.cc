// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/car.h"

#include <algorithm>
#include <cmath>

namespace latchwork::traffic {

namespace {

constexpr double kLag = 0.2;               // s
constexpr double kEngine = 3.0;            // m/s^2 from a stand
constexpr double kTopSpeed = 55.0;         // m/s, where the engine gives no more
constexpr double kSideSpeed = 1.2;         // m/s
constexpr double kSideAcceleration = 1.0;  // m/s^2
constexpr double kSteepest = 0.3;          // sideways per forward

/// Sideways speed from which a car can still come to rest on the middle of its lane.
double WantedSideSpeed(const Car& car, double dt) {
  const double left = car.aim * kLaneWidth - car.y;
  const double size = std::min({kSideSpeed, std::sqrt(1.4 * kSideAcceleration * std::abs(left)),
                                std::abs(left) / dt, kSteepest * car.speed});
  return std::copysign(size, left);
}

}  // namespace

int Car::lane() const { return static_cast<int>(std::lround(y / kLaneWidth)); }

bool Car::settled() const { return std::abs(y - aim * kLaneWidth) < 0.3; }

void Move(Car& car, double command, double dt) {
  const double share = car.speed / kTopSpeed;
  const double engine = std::max(0.0, kEngine * (1.0 - share * share));
  const double wanted = std::clamp(command, -kHardestBraking, engine);
  car.acceleration += (wanted - car.acceleration) * (1.0 - std::exp(-dt / kLag));
  const double next = std::max(0.0, car.speed + car.acceleration * dt);
  if (next == 0.0) car.acceleration = std::max(0.0, car.acceleration);
  car.s += (car.speed + next) / 2 * dt;
  car.speed = next;

  const double most = kSideAcceleration * dt;
  const double change = WantedSideSpeed(car, dt) - car.side_speed;
  car.side_speed += std::clamp(change, -most, most);
  const double limit = kSteepest * car.speed;
  car.side_speed = std::clamp(car.side_speed, -limit, limit);
  car.y += car.side_speed * dt;
}

}  // namespace latchwork::traffic
