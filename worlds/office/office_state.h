// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_OFFICE_STATE_H_
#define LATCHWORK_OFFICE_OFFICE_STATE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "worlds/office/boxes.h"
#include "worlds/office/building.h"
#include "worlds/office/collision.h"
#include "worlds/office/destinations.h"
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
  bool shuts = false;  ///< Somebody shuts it, and it does not go on while the robot is in it.
};

/// Everything that one run of the office changes. Made by MakeOffice, stepped by OfficeWorld.
struct OfficeState {
  explicit OfficeState(Building loaded) : building(std::move(loaded)), tracker(building) {}
  OfficeState(const OfficeState&) = delete;
  OfficeState& operator=(const OfficeState&) = delete;
  OfficeState(OfficeState&&) = delete;
  OfficeState& operator=(OfficeState&&) = delete;
  ~OfficeState() = default;

  FloorMap& map() { return maps[static_cast<std::size_t>(floor)]; }
  Point place() const { return PointOf(vehicle->pose()); }  ///< Of the robot.
  /// Nothing may close, appear or move in within this distance of the robot's centre, m: it could
  /// not stop in time.
  double reach() const;
  /// Opens or shuts a door, whatever stands in it.
  void SetDoor(std::size_t door, bool shut);
  /// Shuts a door now, or as soon as the robot has left it.
  void ShutDoorOnceClear(std::size_t door);
  /// One tick of the doors that wait.
  void ShutWaitingDoors();
  /// Makes the elevators' leaves agree with their doors.
  void SyncElevatorLeaves();
  void PutBox(const Box& box);
  /// Something that the picture shows where the robot is.
  void Remark(std::uint64_t tick, std::string text);

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
  std::optional<Destinations> destinations;  ///< Only where the world names places to go.
  std::vector<Elevator> elevators;
  std::vector<Leaf> doors;                         ///< By door of the building.
  std::vector<std::vector<Leaf>> elevator_leaves;  ///< By elevator and floor.
  Record record;                                   ///< What the picture shows.
};

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_OFFICE_STATE_H_
