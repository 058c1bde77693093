// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_MAP_BUILDING_MAP_H_
#define LATCHWORK_OMPL_MAP_BUILDING_MAP_H_

#include <cstdint>
#include <filesystem>
#include <map>

#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "reasoners/ompl/map/distance_map.h"

namespace latchwork::planning {

/// A named place; `floor` is 0 in a cab.
struct Place {
  std::int64_t floor = 0;
  Point at;
};

/// What a planner needs of a building: its floors by number, and where its landmarks are.
struct BuildingMap {
  std::map<std::int64_t, DistanceMap> floors;
  std::map<logic::Symbol, Place> landmarks;
};

struct ReadBuildingMap {
  BuildingMap map;
  logic::Diagnostics diagnostics;  ///< Not empty: `map` must not be used.
};

/// Of a building's TPTP file: its clauses floor(Number, Image, MetresPerPixel), with the PNG
/// pictures beside it, and landmark(Name, Floor, X, Y); other clauses do not matter. Of a PNG
/// picture: floor 1 alone, without landmarks, at the given resolution. `place` is where the file
/// was named.
ReadBuildingMap ReadBuilding(const std::filesystem::path& file, double resolution,
                             const logic::SourcePlace& place, logic::SymbolTable& symbols);

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_MAP_BUILDING_MAP_H_
