// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/office_state.h"

#include <utility>

namespace latchwork::office {

namespace {

constexpr double kGap = 0.15;      // beyond the robot's rim, m
constexpr double kReaction = 0.3;  // s

void Move(Leaf& leaf, FloorMap& map, bool shut) {
  if (leaf.shut == shut) return;
  leaf.shut = shut;
  if (shut) {
    Cover(map, leaf.cells);
  } else {
    Uncover(map, leaf.cells);
  }
}

}  // namespace

double OfficeState::reach() const {
  const double speed = vehicle->speed();
  const double braking = speed * speed / (2.0 * vehicle->options().brake);
  return radius + kGap + speed * kReaction + braking;
}

void OfficeState::SetDoor(std::size_t door, bool shut) {
  doors[door].shuts = shut;
  Move(doors[door], maps[static_cast<std::size_t>(building.doors[door].floor)], shut);
}

void OfficeState::ShutDoorOnceClear(std::size_t door) {
  const Door& d = building.doors[door];
  doors[door].shuts = true;
  if (d.floor != floor || Distance(place(), d.leaf) > reach()) SetDoor(door, true);
}

void OfficeState::ShutWaitingDoors() {
  for (std::size_t door = 0; door < doors.size(); ++door) {
    if (doors[door].shuts && !doors[door].shut) ShutDoorOnceClear(door);
  }
}

void OfficeState::SyncElevatorLeaves() {
  for (std::size_t e = 0; e < elevators.size(); ++e) {
    for (std::size_t f = 0; f < maps.size(); ++f) {
      const bool here = static_cast<int>(f) == elevators[e].floor();
      Move(elevator_leaves[e][f], maps[f], !here || elevators[e].is_shut());
    }
  }
}

void OfficeState::PutBox(const Box& box) {
  FloorMap& map_of_box = maps[static_cast<std::size_t>(box.floor)];
  Cover(map_of_box, CellsOf(map_of_box, box.area));
  record.boxes.push_back(box);
}

void OfficeState::Remark(std::uint64_t tick, std::string text) {
  record.remarks.push_back({tick, floor, place(), std::move(text)});
}

}  // namespace latchwork::office
