// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_GEOMETRY_H_
#define LATCHWORK_OFFICE_GEOMETRY_H_

#include <algorithm>
#include <cmath>
#include <numbers>

namespace latchwork::office {

/// Metres in the building frame: x to the east, y to the north.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

struct Pose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;  ///< rad, counter-clockwise from east, in (-pi, pi].
};

struct Segment {
  Point a;
  Point b;
};

struct Rect {
  double x1 = 0.0;
  double y1 = 0.0;
  double x2 = 0.0;
  double y2 = 0.0;

  bool Contains(Point p) const { return p.x >= x1 && p.x <= x2 && p.y >= y1 && p.y <= y2; }
  Point centre() const { return {(x1 + x2) / 2, (y1 + y2) / 2}; }
};

inline double Distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }
inline Point PointOf(const Pose& pose) { return {pose.x, pose.y}; }

/// Maps an angle to (-pi, pi].
inline double WrapAngle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

/// From a point to the nearest point of a segment.
inline double Distance(Point p, const Segment& s) {
  const double dx = s.b.x - s.a.x;
  const double dy = s.b.y - s.a.y;
  const double squared = dx * dx + dy * dy;
  const double along = squared > 0.0 ? ((p.x - s.a.x) * dx + (p.y - s.a.y) * dy) / squared : 0.0;
  const double t = std::clamp(along, 0.0, 1.0);
  return Distance(p, Point{s.a.x + t * dx, s.a.y + t * dy});
}

/// From a point to the nearest point of a rectangle; 0 inside.
inline double Distance(Point p, const Rect& r) {
  const double dx = std::max({r.x1 - p.x, 0.0, p.x - r.x2});
  const double dy = std::max({r.y1 - p.y, 0.0, p.y - r.y2});
  return std::hypot(dx, dy);
}

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_GEOMETRY_H_
