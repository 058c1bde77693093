// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_OFFICE_STATE_H_
#define LATCHWORK_OFFICE_OFFICE_STATE_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latchwork/logic/diagnostic.h"
#include "latchwork/sdk/parameters.h"
#include "latchwork/sdk/world.h"
#include "worlds/office/boxes.h"
#include "worlds/office/building.h"
#include "worlds/office/collision.h"
#include "worlds/office/elevator.h"
#include "worlds/office/localization.h"
#include "worlds/office/people.h"
#include "worlds/office/picture.h"
#include "worlds/office/sonar.h"
#include "worlds/office/vehicle.h"

namespace latchwork::office {

/// Something solid that comes and goes: a door leaf.
struct Leaf {
  std::vector<CellIndex> cells;
  bool shut = false;
};

/// Everything that one run of the office changes. Made by MakeOffice, stepped by OfficeWorld.
struct OfficeState {
  explicit OfficeState(Building loaded) : building(std::move(loaded)), tracker(building) {}
  OfficeState(const OfficeState&) = delete;
  OfficeState& operator=(const OfficeState&) = delete;

  FloorMap& map() { return maps[static_cast<std::size_t>(floor)]; }
  void SetDoor(std::size_t door, bool shut);
  /// Makes the elevators' leaves agree with their doors.
  void SyncElevatorLeaves();

  const Building building;
  std::vector<FloorMap> maps;  ///< The building's, with what stands in it in this run.
  int floor = 0;               ///< Of the robot; an index.
  std::optional<std::size_t> goal;
  double radius = 0.25;
  std::optional<Vehicle> vehicle;
  std::optional<SonarRing> sonars;
  std::optional<People> people;
  std::optional<Odometry> odometry;
  LandmarkTracker tracker;
  std::vector<Elevator> elevators;
  std::vector<Leaf> doors;                         ///< By door of the building.
  std::vector<std::vector<Leaf>> elevator_leaves;  ///< By elevator and floor.
  std::vector<char> seen_shut;                     ///< By door.
  Record record;                                   ///< What the picture shows.
};

struct MadeOffice {
  std::unique_ptr<OfficeState> state;
  logic::Diagnostics diagnostics;
};

/// Sets up a run from parameters that passed OfficeParameters; every mistake with the place of its
/// parameter.
MadeOffice MakeOffice(const sdk::WorldSetup& setup, const sdk::Parameters& parameters);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_OFFICE_STATE_H_
