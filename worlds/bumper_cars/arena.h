// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BUMPER_CARS_ARENA_H_
#define LATCHWORK_BUMPER_CARS_ARENA_H_

#include <span>
#include <string>
#include <vector>

#include "worlds/bumper_cars/car.h"
#include "worlds/bumper_cars/contact.h"

namespace latchwork::bumper_cars {

constexpr double kPoleRadius = 0.15;  // m
constexpr double kTouch = 0.03;       // m; a gap that counts as touching

struct Pole {
  std::string name;
  Vector place;
};

/// A bump between cars `a` and `b`, a < b.
struct Bump {
  std::size_t a = 0;
  std::size_t b = 0;
  Impact impact;
};

/// A floor with walls around it, power poles on it, and cars; the first is the agent's.
struct Arena {
  Vector size;
  Vector gate;  ///< Where cars are entered and left.
  std::vector<Pole> poles;
  std::vector<Car> cars;

  /// Moves all cars on by `seconds`, in small steps; `controls` has one entry for each. Returns the
  /// bumps between cars. A car that touches a pole is charged.
  std::vector<Bump> Step(std::span<const Controls> controls, double seconds);

  /// From the rim of the car, along a direction relative to its heading, to a wall or pole.
  double ClearAhead(const Car& car, double direction) const;
  bool TouchesWall(const Car& car) const;
  bool Touches(const Car& car, const Pole& pole) const {
    return Length(pole.place - car.place) < kCarRadius + kPoleRadius + kTouch;
  }
  static bool Touch(const Car& a, const Car& b) {
    return Length(a.place - b.place) < 2 * kCarRadius + kTouch;
  }
};

}  // namespace latchwork::bumper_cars

#endif  // LATCHWORK_BUMPER_CARS_ARENA_H_
