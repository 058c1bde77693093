// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_PATHS_FIND_PATH_H_
#define LATCHWORK_OMPL_PATHS_FIND_PATH_H_

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/ompl/map/free_space.h"
#include "reasoners/ompl/paths/effort.h"

namespace latchwork::planning {

/// What is planned in. The Dubins car is left out: OMPL 1.5 aborts on rounding errors in it.
enum class SpaceKind : std::uint8_t { kPlane, kPlaneAndHeading, kReedsShepp };

struct PathSettings {
  std::string planner = "RRTConnect";
  std::vector<std::pair<std::string, std::string>> options;  ///< Of the planner, checked before.
  SpaceKind space = SpaceKind::kPlane;
  double turning_radius = 0.5;     ///< m, of a Reeds-Shepp car
  double snap = 1.0;               ///< m; an end that is not free is moved at most so far.
  std::uint64_t effort = 100'000;  ///< For one path; the budget's rest, if that is less.
  std::uint64_t seed = 1;
  std::uint64_t attempt = 0;  ///< Another seed for what failed before.
  int tries = 3;              ///< The shortest path of so many counts.
  bool simplify = true;
  bool optimize = false;  ///< Optimizing planners go on until the effort is spent.
};

struct PathStart {
  Point at;
  std::optional<double> heading;  ///< rad, for spaces that have one; none: whichever suits.
};

using Path = std::vector<Point>;  ///< Corners; at least two.

double Length(const Path& path);

struct FoundPath {
  enum class State : std::uint8_t {
    kFound,
    kNone,     ///< There is none, for certain: by the map, not by the planner.
    kUnknown,  ///< The planner found none with what it may spend.
  };
  State state = State::kUnknown;
  Path path;
};

/// A path that keeps the clearance of `space`, by a planner of OMPL; it may end with any heading. A
/// function of its arguments alone. Thread rule: safe, but calls wait for each other: the seed of
/// OMPL is the process's.
FoundPath FindPath(const FreeSpace& space, const PathStart& from, Point to,
                   const PathSettings& settings, Effort& effort);

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_PATHS_FIND_PATH_H_
