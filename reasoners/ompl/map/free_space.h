// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_MAP_FREE_SPACE_H_
#define LATCHWORK_OMPL_MAP_FREE_SPACE_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "reasoners/ompl/map/distance_map.h"

namespace latchwork::planning {

/// Something round that is in the way and not in the map, such as a door that is shut.
struct Disc {
  Point centre;
  double radius = 0.0;
};

/// Where on a floor the robot's centre may be: no nearer than `clearance` to anything. Thread rule:
/// const members from any thread. `map` outlives it.
class FreeSpace {
 public:
  FreeSpace(const DistanceMap& map, double clearance, std::vector<Disc> discs = {});

  const DistanceMap& map() const { return *map_; }
  /// Nothing is nearer than this, m.
  double Clearance(Point place) const;
  bool IsFree(Point place) const { return Clearance(place) >= clearance_; }
  /// The whole way from a to b, to within an eighth of a cell: steps as long as the clearance
  /// allows, so nothing is cut however thin it is.
  bool IsFree(Point a, Point b) const;
  /// False: there is no way from a to b, whatever a planner may find. By filling the cells that
  /// hold any free place.
  bool MayConnect(Point a, Point b) const;
  /// `place`, or the nearest free centre of a cell within the distance.
  std::optional<Point> NearestFree(Point place, double within) const;

 private:
  void Fill(int x, int y, std::int32_t label, std::vector<std::int32_t>& stack);
  bool MayHold(int x, int y) const;
  std::int32_t LabelAt(Point place) const;

  const DistanceMap* map_;
  double clearance_;
  std::vector<Disc> discs_;
  std::vector<std::int32_t> labels_;  ///< Of connected cells; 0: no free place.
};

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_MAP_FREE_SPACE_H_
