// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/make_office.h"

#include <algorithm>
#include <utility>

#include "worlds/office/making.h"

namespace latchwork::office {

namespace {

constexpr double kLeafThickness = 0.1;

LoadedBuilding LoadPlan(const sdk::WorldSetup& setup, const sdk::Parameters& parameters) {
  const auto map = parameters.File("map");
  const auto file = parameters.File("building");
  if (!map.empty() && !file.empty()) {
    LoadedBuilding both;
    both.diagnostics.push_back(
        {parameters.PlaceOf("map"), "both a building and a map are given", "leave one out", {}});
    return both;
  }
  if (!map.empty()) {
    return ReadBareMap(map, parameters.Real("resolution"), parameters.PlaceOf("map"));
  }
  const auto shipped = setup.data / "data" / "building" / "building.p";
  return ReadBuilding(file.empty() ? shipped : file, *setup.symbols);
}

int FloorNamed(Making& making, std::string_view parameter, std::string_view word) {
  const auto number = Number(word);
  const auto floor = number ? making.building().FindFloor(static_cast<int>(*number)) : std::nullopt;
  if (!floor) making.Fail(parameter, "the building has no floor '" + std::string(word) + "'");
  return floor.value_or(0);
}

void MakeElevators(Making& making) {
  const sdk::Parameters& parameters = making.parameters;
  const ElevatorOptions options{
      parameters.Real("elevator_door_time"), parameters.Real("elevator_dwell_time"),
      parameters.Real("elevator_floor_time"), parameters.Real("elevator_calls")};
  const auto floors = Words(parameters.Text("elevator_floors"));
  const std::size_t count = making.building().floors.size();
  for (std::size_t i = 0; i < making.building().elevators.size(); ++i) {
    const ElevatorShaft& shaft = making.building().elevators[i];
    Elevator& elevator = making.state.elevators.emplace_back(options, static_cast<int>(count),
                                                             making.setup.tick_seconds,
                                                             making.setup.seed, shaft.name.name());
    elevator.PutAt(i < floors.size() ? FloorNamed(making, "elevator_floors", floors[i])
                                     : static_cast<int>(making.random.Index(count, 1, i)));
    auto& leaves = making.state.elevator_leaves.emplace_back();
    for (const FloorMap& map : making.state.maps) {
      leaves.push_back({CellsOf(map, shaft.door, kLeafThickness), false, false});
    }
  }
  making.state.SyncElevatorLeaves();
}

void MakeDoors(Making& making) {
  for (const Door& door : making.building().doors) {
    const FloorMap& map = making.state.maps[static_cast<std::size_t>(door.floor)];
    making.state.doors.push_back({CellsOf(map, door.leaf, kLeafThickness), false, false});
  }
  for (const auto word : Words(making.parameters.Text("shut"))) {
    const auto door = making.building().FindDoor(word);
    if (door) {
      making.state.SetDoor(*door, true);
    } else {
      making.FailName("shut", "door", word, NamesOf(making.building().doors));
    }
  }
}

void MakeGoal(Making& making) {
  const std::string& name = making.parameters.Text("goal");
  if (name.empty()) return;
  making.state.goal = making.building().FindLandmark(name);
  if (!making.state.goal) {
    making.FailName("goal", "landmark", name, NamesOf(making.building().landmarks));
  }
}

void MakePeople(Making& making) {
  PeopleOptions people;
  people.count = static_cast<int>(making.parameters.Integer("people"));
  making.state.people.emplace(people, making.building(), making.setup.tick_seconds,
                              making.setup.seed, making.state.floor, making.state.place());
}

void MakeSenses(Making& making) {
  const sdk::Parameters& parameters = making.parameters;
  OfficeState& state = making.state;
  SonarOptions sonar;
  sonar.count = static_cast<int>(parameters.Integer("sonars"));
  sonar.cone = parameters.Real("sonar_cone") * std::numbers::pi / 180.0;
  sonar.rays = static_cast<int>(parameters.Integer("sonar_rays"));
  sonar.max_range = parameters.Real("sonar_range");
  sonar.min_range = std::min(parameters.Real("sonar_min_range"), sonar.max_range);
  sonar.mount_radius = state.radius;
  sonar.noise = parameters.Real("sonar_noise");
  sonar.missed = parameters.Real("sonar_missed");
  state.sonars.emplace(sonar, making.setup.seed);
  state.odometry.emplace(parameters.Real("odometry_noise"), making.setup.seed);
  state.tracker.Reset(state.maps, state.floor, state.place(), state.radius);
}

void MakeDestinations(Making& making) {
  if (making.parameters.Text("destinations") != "random") return;
  OfficeState& state = making.state;
  state.destinations.emplace(making.setup.seed, state.radius, making.setup.tick_seconds);
  state.destinations->Update(state.map(), state.place());
}

}  // namespace

MadeOffice MakeOffice(const sdk::WorldSetup& setup, const sdk::Parameters& parameters) {
  LoadedBuilding loaded = LoadPlan(setup, parameters);
  if (!loaded.diagnostics.empty()) return {nullptr, std::move(loaded.diagnostics)};
  auto state = std::make_unique<OfficeState>(std::move(loaded.building));
  for (const Storey& storey : state->building.floors) state->maps.push_back(storey.map);
  Making making{setup, parameters, sdk::RandomStream(setup.seed, "office"), *state, {}};
  MakeElevators(making);
  MakeDoors(making);
  MakeGoal(making);
  PlaceRobot(making);
  if (!making.diagnostics.empty()) return {nullptr, std::move(making.diagnostics)};
  ShutDoorsBySeed(making);
  PutBoxes(making);
  MakePeople(making);
  MakeSenses(making);
  MakeDestinations(making);
  if (!making.diagnostics.empty()) state.reset();
  return {std::move(state), std::move(making.diagnostics)};
}

}  // namespace latchwork::office
