// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "worlds/office/making.h"

namespace latchwork::office {

namespace {

/// Whether the robot is so near a door that it would be caught in it.
bool IsInDoor(const OfficeState& state, std::size_t door) {
  const Door& d = state.building.doors[door];
  return d.floor == state.floor &&
         Distance(PointOf(state.vehicle->pose()), d.leaf) < state.radius + 0.2;
}

void OpenNeighbours(const Building& building, std::size_t at, std::vector<std::size_t>& open) {
  for (const Edge& edge : building.edges) {
    if (edge.a == at) open.push_back(edge.b);
    if (edge.b == at) open.push_back(edge.a);
  }
  for (const ElevatorShaft& shaft : building.elevators) {
    const auto& lobbies = shaft.lobbies;
    if (std::find(lobbies.begin(), lobbies.end(), at) == lobbies.end()) continue;
    open.insert(open.end(), lobbies.begin(), lobbies.end());
  }
}

/// Whether a way of landmarks leads to the goal without a shut door. Elevators link their lobbies.
bool IsGoalLinked(const OfficeState& state) {
  const Building& building = state.building;
  const auto start = state.tracker.current();
  if (!state.goal || !start) return true;
  std::vector<char> seen(building.landmarks.size(), 0);
  for (std::size_t i = 0; i < building.doors.size(); ++i) {
    const auto index = building.FindLandmark(building.doors[i].name.name());
    if (index && state.doors[i].shut) seen[*index] = 1;
  }
  std::vector<std::size_t> open{*start};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    if (at == *state.goal) return true;
    if (seen[at] != 0) continue;
    seen[at] = 1;
    OpenNeighbours(building, at, open);
  }
  return false;
}

}  // namespace

void ShutDoorsBySeed(Making& making) {
  auto wanted = making.parameters.Integer("shut_doors");
  std::vector<std::size_t> order(making.building().doors.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[making.random.Index(i, 6, i)]);
  }
  making.state.tracker.Reset(making.state.maps, making.state.floor,
                             PointOf(making.state.vehicle->pose()), making.state.radius);
  for (const std::size_t door : order) {
    if (wanted == 0) break;
    if (making.state.doors[door].shut || IsInDoor(making.state, door)) continue;
    making.state.SetDoor(door, true);
    if (IsGoalLinked(making.state)) {
      --wanted;
    } else {
      making.state.SetDoor(door, false);
    }
  }
}

}  // namespace latchwork::office
