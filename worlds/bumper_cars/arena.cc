// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/arena.h"

#include <algorithm>
#include <limits>

namespace latchwork::bumper_cars {
namespace {

constexpr double kSmallStep = 0.01;  // s

/// Along a ray to a disc, or beyond everything.
double ToDisc(Vector from, Vector along, Vector centre, double radius) {
  const Vector to = centre - from;
  const double ahead = Dot(to, along);
  const double aside = Dot(to, Left(along));
  if (ahead <= 0 || std::abs(aside) >= radius) return std::numeric_limits<double>::infinity();
  return ahead - std::sqrt(radius * radius - aside * aside);
}

double ToWall(double place, double along, double size) {
  if (along > 0) return (size - place) / along;
  if (along < 0) return -place / along;
  return std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<Bump> Arena::Step(std::span<const Controls> controls, double seconds) {
  std::vector<Bump> bumps;
  const int steps = std::max(1, static_cast<int>(std::lround(seconds / kSmallStep)));
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < cars.size(); ++i) Drive(controls[i], seconds / steps, cars[i]);
    for (std::size_t a = 0; a < cars.size(); ++a) {
      for (std::size_t b = a + 1; b < cars.size(); ++b) {
        if (const auto impact = Collide(cars[a], cars[b])) bumps.push_back({a, b, *impact});
      }
    }
    for (Car& car : cars) {
      for (const Pole& pole : poles) {
        CollideWithPost(pole.place, kPoleRadius, car);
        if (Touches(car, pole)) car.charge = car.full_charge;
      }
      CollideWithWalls(size, car);
    }
  }
  return bumps;
}

double Arena::ClearAhead(const Car& car, double direction) const {
  const Vector along = Along(car.heading + direction);
  double nearest =
      std::min(ToWall(car.place.x, along.x, size.x), ToWall(car.place.y, along.y, size.y));
  for (const Pole& pole : poles) {
    nearest = std::min(nearest, ToDisc(car.place, along, pole.place, kPoleRadius));
  }
  return std::max(0.0, nearest - kCarRadius);
}

bool Arena::TouchesWall(const Car& car) const {
  const double reach = kCarRadius + kTouch;
  return car.place.x < reach || car.place.y < reach || car.place.x > size.x - reach ||
         car.place.y > size.y - reach;
}

}  // namespace latchwork::bumper_cars
