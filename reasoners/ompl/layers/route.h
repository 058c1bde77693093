// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_LAYERS_ROUTE_H_
#define LATCHWORK_OMPL_LAYERS_ROUTE_H_

#include <optional>
#include <string>
#include <vector>

#include "reasoners/ompl/layers/legs.h"

namespace latchwork::planning {

struct Elevator {
  logic::Symbol name;
  logic::Symbol cab;                  ///< The landmark in it.
  std::vector<logic::Symbol> fronts;  ///< The landmarks before its doors.
  std::optional<std::int64_t> at;     ///< The floor where it is, if anybody says so.
  bool usable = true;
};

/// What there is to know about the ways through a building in a cycle.
struct Building {
  std::vector<Elevator> elevators;  ///< By name.
  std::vector<logic::Symbol> shut;  ///< Landmarks of shut doors, sorted.
};

/// A part of a way: on foot along a path, or by elevator.
struct Stage {
  logic::Symbol from;
  logic::Symbol to;
  logic::Symbol elevator;  ///< Null: on foot.
  Path path;               ///< On foot only.
};

struct FoundRoute {
  FoundPath::State state = FoundPath::State::kUnknown;
  std::vector<Stage> stages;  ///< None: already there.
};

/// The shortest way over all floors, where they are joined by the elevators. Who is in a cab leaves
/// it by riding; of one that is out of order, where it is. `from` and `to` are landmarks of the
/// map.
FoundRoute FindRoute(const JobSetup& setup, const Building& building, Legs& legs,
                     logic::Symbol from, logic::Symbol to, Effort& effort);

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_LAYERS_ROUTE_H_
