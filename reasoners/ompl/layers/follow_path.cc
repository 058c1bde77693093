// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/layers/follow_path.h"

#include <algorithm>

namespace latchwork::planning {

Nearest NearestOn(const Path& path, Point place) {
  Nearest best{Distance(path.front(), place), 0.0, 0, path.front()};
  double before = 0.0;
  for (std::size_t leg = 0; leg + 1 < path.size(); ++leg) {
    const Point a = path[leg];
    const Point b = path[leg + 1];
    const double length = Distance(a, b);
    if (length <= 0.0) continue;
    const double dot = (place.x - a.x) * (b.x - a.x) + (place.y - a.y) * (b.y - a.y);
    const double t = std::clamp(dot / (length * length), 0.0, 1.0);
    const Point at = Between(a, b, t);
    if (Distance(at, place) < best.distance) {
      best = {Distance(at, place), before + t * length, leg, at};
    }
    before += length;
  }
  return best;
}

Point PointAt(const Path& path, double along) {
  for (std::size_t leg = 0; leg + 1 < path.size(); ++leg) {
    const double length = Distance(path[leg], path[leg + 1]);
    if (along < length) return Between(path[leg], path[leg + 1], along / length);
    along -= length;
  }
  return path.back();
}

Path RestFrom(const Path& path, Point place) {
  const Nearest nearest = NearestOn(path, place);
  Path rest{place, nearest.at};
  rest.insert(rest.end(), path.begin() + static_cast<std::ptrdiff_t>(nearest.leg) + 1, path.end());
  return rest;
}

}  // namespace latchwork::planning
