// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/layers/legs.h"

#include <algorithm>

namespace latchwork::planning {
namespace {

constexpr double kDoorRadius = 0.6;  // m; covers a leaf of 1 m

}  // namespace

Legs::Legs(const JobSetup& setup) : setup_(setup) {
  for (const auto& [number, map] : setup_.map->floors) {
    spaces_.emplace(number, FreeSpace(map, setup_.clearance));
  }
}

void Legs::Shut(const std::vector<logic::Symbol>& landmarks) {
  if (landmarks == shut_) return;
  shut_ = landmarks;
  known_.clear();
  for (auto& [number, space] : spaces_) {
    std::vector<Disc> discs;
    for (const logic::Symbol landmark : shut_) {
      const auto place = setup_.map->landmarks.find(landmark);
      if (place == setup_.map->landmarks.end() || place->second.floor != number) continue;
      discs.push_back({place->second.at, kDoorRadius});
    }
    space = FreeSpace(setup_.map->floors.at(number), setup_.clearance, std::move(discs));
  }
}

FoundPath Legs::Between(logic::Symbol from, logic::Symbol to, Effort& effort) {
  const auto key = std::minmax(from, to);
  auto known = known_.find(key);
  if (known == known_.end()) {
    const Place& start = setup_.map->landmarks.at(key.first);
    const Place& end = setup_.map->landmarks.at(key.second);
    FoundPath found =
        FindPath(spaces_.at(start.floor), {start.at, {}}, end.at, setup_.paths, effort);
    if (found.state == FoundPath::State::kUnknown) {
      ++setup_.paths
            .attempt;  // What the budget did not suffice for may be found in the next cycle.
      return found;
    }
    known = known_.emplace(key, std::move(found)).first;
  }
  FoundPath found = known->second;
  if (key.first != from) std::reverse(found.path.begin(), found.path.end());
  return found;
}

}  // namespace latchwork::planning
