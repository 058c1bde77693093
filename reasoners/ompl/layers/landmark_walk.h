// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_LAYERS_LANDMARK_WALK_H_
#define LATCHWORK_OMPL_LAYERS_LANDMARK_WALK_H_

#include <map>
#include <vector>

#include "reasoners/ompl/layers/job.h"

namespace latchwork::planning {

/// From which landmarks a straight line leads to each; none into shut doors.
using Neighbours = std::map<logic::Symbol, std::vector<logic::Symbol>>;

/// The first landmark of the walk from `from` to `to` along neighbours that stays near a path
/// (the shortest walk, where a landmark and a metre beside the path count as more metres); `to`,
/// when neighbours do not lead there. `from` and `to` are landmarks of the map; the path has at
/// least two corners.
logic::Symbol FirstOfWalk(const BuildingMap& map, const Neighbours& neighbours, const Path& path,
                          logic::Symbol from, logic::Symbol to);

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_LAYERS_LANDMARK_WALK_H_
