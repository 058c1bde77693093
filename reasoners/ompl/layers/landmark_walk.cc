// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/layers/landmark_walk.h"

#include <set>
#include <utility>

#include "reasoners/ompl/layers/follow_path.h"

namespace latchwork::planning {
namespace {

using logic::Symbol;

constexpr double kStep = 2.0;        // m; so that few landmarks are named
constexpr double kBesidePath = 2.0;  // how many metres of a walk one metre beside it outweighs

/// Dijkstra's algorithm, backwards, so that what `from` is reached by comes next.
class WalkSearch {
 public:
  WalkSearch(const BuildingMap& map, const Neighbours& neighbours, const Path& path)
      : map_(&map), neighbours_(&neighbours), path_(&path) {}

  Symbol First(Symbol from, Symbol to) {
    const auto goal = map_->landmarks.find(to);
    Reach(to, 0.0, to);
    while (!open_.empty()) {
      const auto [cost, landmark] = *open_.begin();
      open_.erase(open_.begin());
      if (landmark == from) return reached_.at(from).next;
      Extend(landmark, cost, goal->second.floor);
    }
    return to;
  }

 private:
  struct Reached {
    double cost = 0.0;
    Symbol next;  ///< From here towards the goal.
  };

  void Reach(Symbol landmark, double cost, Symbol next) {
    const auto [place, is_new] = reached_.try_emplace(landmark, Reached{cost, next});
    if (!is_new) {
      if (cost >= place->second.cost) return;
      open_.erase({place->second.cost, landmark});
      place->second = {cost, next};
    }
    open_.insert({cost, landmark});
  }

  void Extend(Symbol into, double cost, std::int64_t floor) {
    const auto neighbours = neighbours_->find(into);
    if (neighbours == neighbours_->end()) return;
    const Point at = map_->landmarks.at(into).at;
    const double worse = kStep + kBesidePath * NearestOn(*path_, at).distance;
    for (const Symbol from : neighbours->second) {
      const auto place = map_->landmarks.find(from);
      if (place == map_->landmarks.end() || place->second.floor != floor) continue;
      Reach(from, cost + worse + Distance(place->second.at, at), into);
    }
  }

  const BuildingMap* map_;
  const Neighbours* neighbours_;
  const Path* path_;
  std::map<Symbol, Reached> reached_;
  std::set<std::pair<double, Symbol>> open_;
};

}  // namespace

Symbol FirstOfWalk(const BuildingMap& map, const Neighbours& neighbours, const Path& path,
                   Symbol from, Symbol to) {
  return WalkSearch(map, neighbours, path).First(from, to);
}

}  // namespace latchwork::planning
