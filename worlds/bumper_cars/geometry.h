// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BUMPER_CARS_GEOMETRY_H_
#define LATCHWORK_BUMPER_CARS_GEOMETRY_H_

#include <cmath>
#include <numbers>

namespace latchwork::bumper_cars {

struct Vector {
  double x = 0;
  double y = 0;

  friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector operator*(double s, Vector a) { return {s * a.x, s * a.y}; }
  friend bool operator==(const Vector&, const Vector&) = default;
};

inline double Dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
inline double Length(Vector a) { return std::hypot(a.x, a.y); }
inline Vector Along(double heading) { return {std::cos(heading), std::sin(heading)}; }
/// A quarter turn to the left.
inline Vector Left(Vector a) { return {-a.y, a.x}; }
/// In [-pi, pi].
inline double WrapAngle(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace latchwork::bumper_cars

#endif  // LATCHWORK_BUMPER_CARS_GEOMETRY_H_
