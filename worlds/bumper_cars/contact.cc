// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/contact.h"

#include <algorithm>
#include <cmath>

namespace latchwork::bumper_cars {
namespace {

constexpr double kElastic = 0.6;     // restitution of the rubber
constexpr double kYieldSpeed = 0.5;  // m/s
constexpr double kFriction = 0.2;    // of rubber on rubber that slides
constexpr double kInertia = 0.5 * kCarMass * kCarRadius * kCarRadius;  // of a disc

/// One of the two bodies of a contact; without a car it stands firmly.
struct Side {
  Car* car = nullptr;

  double inverse_mass() const { return car != nullptr ? 1 / kCarMass : 0; }
  double spin_mobility() const { return car != nullptr ? kCarRadius * kCarRadius / kInertia : 0; }
  Vector velocity() const { return car != nullptr ? car->velocity : Vector{}; }
  double rim_speed() const { return car != nullptr ? car->spin * kCarRadius : 0; }
  void Push(Vector impulse, double across) const {
    if (car == nullptr) return;
    car->velocity = car->velocity + inverse_mass() * impulse;
    car->spin += across * kCarRadius / kInertia;
  }
};

/// `normal` points from a to b; they overlap by `overlap`.
std::optional<Impact> Resolve(const Side& a, const Side& b, Vector normal, double overlap,
                              Vector place) {
  const double mobility = a.inverse_mass() + b.inverse_mass();
  if (a.car != nullptr) {
    a.car->place = a.car->place - (overlap * a.inverse_mass() / mobility) * normal;
  }
  if (b.car != nullptr) {
    b.car->place = b.car->place + (overlap * b.inverse_mass() / mobility) * normal;
  }
  const Vector relative = a.velocity() - b.velocity();
  const double closing = Dot(relative, normal);
  if (closing <= 0) return std::nullopt;
  const Impact impact{place, closing, std::max(0.0, Dot(a.velocity(), normal)),
                      std::max(0.0, -Dot(b.velocity(), normal))};
  const double push = (1 + Restitution(closing)) * closing / mobility;
  // Both rims move across the normal by their own turning as well.
  const double sliding = Dot(relative, Left(normal)) + a.rim_speed() + b.rim_speed();
  const double across = std::clamp(sliding / (mobility + a.spin_mobility() + b.spin_mobility()),
                                   -kFriction * push, kFriction * push);
  const Vector impulse = push * normal + across * Left(normal);
  a.Push(-1 * impulse, -across);
  b.Push(impulse, -across);
  return impact;
}

}  // namespace

double Restitution(double closing) {
  return closing <= kYieldSpeed ? kElastic : kElastic * std::pow(kYieldSpeed / closing, 0.25);
}

std::optional<Impact> Collide(Car& a, Car& b) {
  const Vector apart = b.place - a.place;
  const double distance = Length(apart);
  if (distance >= 2 * kCarRadius) return std::nullopt;
  const Vector normal = distance > 0 ? (1 / distance) * apart : Vector{1, 0};
  return Resolve({&a}, {&b}, normal, 2 * kCarRadius - distance, a.place + kCarRadius * normal);
}

std::optional<Impact> CollideWithPost(Vector centre, double radius, Car& car) {
  const Vector apart = centre - car.place;
  const double distance = Length(apart);
  if (distance >= kCarRadius + radius) return std::nullopt;
  const Vector normal = distance > 0 ? (1 / distance) * apart : Vector{1, 0};
  return Resolve({&car}, {}, normal, kCarRadius + radius - distance,
                 car.place + kCarRadius * normal);
}

std::optional<Impact> CollideWithWalls(Vector size, Car& car) {
  std::optional<Impact> hardest;
  const auto wall = [&](Vector normal, double gap) {
    if (gap >= 0) return;
    const auto impact = Resolve({&car}, {}, normal, -gap, car.place + kCarRadius * normal);
    if (impact && (!hardest || impact->closing > hardest->closing)) hardest = impact;
  };
  wall({-1, 0}, car.place.x - kCarRadius);
  wall({1, 0}, size.x - kCarRadius - car.place.x);
  wall({0, -1}, car.place.y - kCarRadius);
  wall({0, 1}, size.y - kCarRadius - car.place.y);
  return hardest;
}

}  // namespace latchwork::bumper_cars
