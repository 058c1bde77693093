// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_PATHS_OMPL_QUERY_H_
#define LATCHWORK_OMPL_PATHS_OMPL_QUERY_H_

#include <cstdint>

#include "reasoners/ompl/paths/find_path.h"

namespace latchwork::planning {

struct PlannerQuestion {
  const FreeSpace& space;
  PathStart from;  ///< Free, and so is `to`.
  Point to;
  const PathSettings& settings;
  std::uint64_t attempt = 0;     ///< Each has a seed of its own.
  std::uint64_t effort_end = 0;  ///< The planner stops when so much is spent in all.
};

/// The corners of the path that the planner found, or none.
Path AskPlanner(const PlannerQuestion& question, Effort& effort);

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_PATHS_OMPL_QUERY_H_
