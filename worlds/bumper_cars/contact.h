// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BUMPER_CARS_CONTACT_H_
#define LATCHWORK_BUMPER_CARS_CONTACT_H_

#include <optional>

#include "worlds/bumper_cars/car.h"

namespace latchwork::bumper_cars {

/// What two bodies that came together were about to do.
struct Impact {
  Vector place;
  double closing = 0;  ///< m/s, with which the gap was closing.
  double first = 0;    ///< m/s, with which the first of them drove at the other.
  double second = 0;   ///< m/s, the other way round; 0 for what stands firmly.
};

/// What is left of the speed of an impact. Slow ones are elastic up to the loss in the rubber;
/// above a speed of yielding the ring gives way for good and the ratio falls with the fourth root
/// of the speed. Source: K. L. Johnson, Contact Mechanics (1985), section 11.5.
double Restitution(double closing);

/// Two cars that overlap: pushes them apart and exchanges momentum, along the line of their centres
/// and, by friction of the rings, across it. Nothing when they do not touch or move apart already.
std::optional<Impact> Collide(Car& a, Car& b);

/// A car and a firm disc.
std::optional<Impact> CollideWithPost(Vector centre, double radius, Car& car);

/// A car and the walls of the rectangle from (0, 0) to `size`.
std::optional<Impact> CollideWithWalls(Vector size, Car& car);

}  // namespace latchwork::bumper_cars

#endif  // LATCHWORK_BUMPER_CARS_CONTACT_H_
