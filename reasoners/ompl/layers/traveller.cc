// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/layers/traveller.h"

#include <algorithm>

#include "reasoners/ompl/layers/follow_path.h"
#include "reasoners/ompl/layers/landmark_walk.h"

namespace latchwork::planning {
namespace {

constexpr double kOnPath = 2.5;  // m; who is farther from a path has left it

Elevator& Named(std::vector<Elevator>& elevators, logic::Symbol name) {
  const auto found = std::find_if(elevators.begin(), elevators.end(),
                                  [&](const Elevator& elevator) { return elevator.name == name; });
  if (found != elevators.end()) return *found;
  elevators.push_back({name, {}, {}, {}, true});
  return elevators.back();
}

}  // namespace

Traveller::Traveller(const JobSetup& setup, logic::SymbolTable& symbols)
    : setup_(setup),
      legs_(setup),
      adjacent_(symbols.Intern("adjacent")),
      elevator_front_(symbols.Intern("elevator_front")),
      cab_(symbols.Intern("cab")),
      elevator_at_(symbols.Intern("elevator_at")),
      out_of_order_(symbols.Intern("elevator_out_of_order")),
      door_shut_(symbols.Intern("door_shut")) {}

std::string Traveller::Unknown(logic::Symbol landmark) const {
  if (setup_.map->landmarks.contains(landmark)) return {};
  return "the map has no landmark '" + std::string(landmark.name()) + "'";
}

const Building& Traveller::Observe(const LatchFacts& latches) {
  std::vector<Elevator>& elevators = building_.elevators;
  elevators.clear();
  building_.shut.clear();
  latches.ForEach({elevator_front_, 3}, [&](auto terms) {
    Named(elevators, terms[0].symbol()).fronts.push_back(terms[1].symbol());
  });
  latches.ForEach({cab_, 2},
                  [&](auto terms) { Named(elevators, terms[0].symbol()).cab = terms[1].symbol(); });
  latches.ForEach({elevator_at_, 2},
                  [&](auto terms) { Named(elevators, terms[0].symbol()).at = terms[1].integer(); });
  latches.ForEach({out_of_order_, 1},
                  [&](auto terms) { Named(elevators, terms[0].symbol()).usable = false; });
  latches.ForEach({door_shut_, 1},
                  [&](auto terms) { building_.shut.push_back(terms[0].symbol()); });
  std::sort(building_.shut.begin(), building_.shut.end());
  std::sort(elevators.begin(), elevators.end(),
            [](const Elevator& a, const Elevator& b) { return a.name < b.name; });
  return building_;
}

Outlook Traveller::Look(const LatchFacts& latches, logic::Symbol here, logic::Symbol target,
                        Effort& effort) {
  Observe(latches);
  KeepTo(target);
  if (!GoOn(here)) {
    legs_.Shut(building_.shut);
    FoundRoute found = FindRoute(setup_, building_, legs_, here, target, effort);
    stages_ = std::move(found.stages);
    if (found.state != FoundPath::State::kFound) return {found.state, {}, {}};
  }
  if (stages_.empty()) return {FoundPath::State::kFound, target, {}};
  const Stage& stage = stages_.front();
  if (stage.elevator) return {FoundPath::State::kFound, stage.to, stage.elevator};
  return {FoundPath::State::kFound, NextOnFoot(latches, stage), {}};
}

/// Drops a route that led elsewhere, or rested on other doors and elevators.
void Traveller::KeepTo(logic::Symbol target) {
  std::vector<logic::Symbol> closed = building_.shut;
  for (const Elevator& elevator : building_.elevators) {
    if (!elevator.usable) closed.push_back(elevator.name);
  }
  if (target != target_ || closed != closed_) stages_.clear();
  target_ = target;
  closed_ = std::move(closed);
}

/// Whether the route still fits who is at `here`; drops what lies behind.
bool Traveller::GoOn(logic::Symbol here) {
  while (!stages_.empty() && stages_.front().to == here) stages_.erase(stages_.begin());
  if (stages_.empty()) return false;
  Stage& stage = stages_.front();
  if (stage.elevator) return StillRides(stage, here);
  if (stage.from == here) return true;
  const Place& place = PlaceOf(here);
  if (place.floor != PlaceOf(stage.to).floor) return false;
  if (NearestOn(stage.path, place.at).distance > kOnPath) return false;
  stage.path = RestFrom(stage.path, place.at);
  stage.from = here;
  return true;
}

/// Whether who is at `here`, in the cab or where the ride begins, can take it. One that is out of
/// order stops somewhere, and goes nowhere else.
bool Traveller::StillRides(const Stage& stage, logic::Symbol here) const {
  const auto& elevators = building_.elevators;
  const auto ridden = std::find_if(elevators.begin(), elevators.end(), [&](const Elevator& each) {
    return each.name == stage.elevator && each.cab == here;
  });
  if (ridden == elevators.end()) return stage.from == here;
  return ridden->usable || ridden->at == PlaceOf(stage.to).floor;
}

/// No walk leads into a shut door; who stands in one may leave.
logic::Symbol Traveller::NextOnFoot(const LatchFacts& latches, const Stage& stage) const {
  Neighbours before;
  latches.ForEach({adjacent_, 2}, [&](auto terms) {
    const logic::Symbol into = terms[1].symbol();
    if (std::binary_search(building_.shut.begin(), building_.shut.end(), into)) return;
    if (Unknown(into).empty()) before[into].push_back(terms[0].symbol());
  });
  return FirstOfWalk(*setup_.map, before, stage.path, stage.from, stage.to);
}

}  // namespace latchwork::planning
