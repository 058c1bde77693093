// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_LAYERS_FOLLOW_PATH_H_
#define LATCHWORK_OMPL_LAYERS_FOLLOW_PATH_H_

#include "reasoners/ompl/paths/find_path.h"

namespace latchwork::planning {

/// Where a path comes nearest to a place.
struct Nearest {
  double distance = 0.0;  ///< m, from the place
  double along = 0.0;     ///< m, from the path's start
  std::size_t leg = 0;    ///< Between the corners `leg` and `leg` + 1.
  Point at;
};

/// The first of equally near ones. `path` has at least two corners.
Nearest NearestOn(const Path& path, Point place);
/// The point so far from the start, or the end.
Point PointAt(const Path& path, double along);
/// What is left of the path for who is at `place`, near it.
Path RestFrom(const Path& path, Point place);

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_LAYERS_FOLLOW_PATH_H_
