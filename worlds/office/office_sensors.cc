// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/office_sensors.h"

#include <cmath>

#include "worlds/office/office_contract.h"

namespace latchwork::office {

namespace {

using logic::Fact;
using logic::Term;

/// The number that people give a floor; 0 for a place in a cab.
Term FloorNumber(const Building& building, int floor) {
  if (floor < 0) return Term::Integer(0);
  return Term::Integer(building.floors[static_cast<std::size_t>(floor)].number);
}

Term NameOf(const Building& building, std::size_t landmark) {
  return Term::Constant(building.landmarks[landmark].name);
}

}  // namespace

OfficeSensors::OfficeSensors(logic::SymbolTable& symbols)
    : sonar_reading_(symbols.Intern("sonar_reading")),
      no_echo_(symbols.Intern("no_echo")),
      sonar_direction_(symbols.Intern("sonar_direction")),
      robot_radius_(symbols.Intern("robot_radius")),
      curr_location_(symbols.Intern("curr_location")),
      curr_heading_(symbols.Intern("curr_heading")),
      curr_floor_(symbols.Intern("curr_floor")),
      curr_landmark_(symbols.Intern("curr_landmark")),
      landmark_(symbols.Intern("landmark")),
      adjacent_(symbols.Intern("adjacent")),
      elevator_(symbols.Intern("elevator")),
      elevator_front_(symbols.Intern("elevator_front")),
      cab_(symbols.Intern("cab")),
      elevator_at_(symbols.Intern("elevator_at")),
      elevator_open_(symbols.Intern("elevator_open")),
      elevator_out_of_order_(symbols.Intern("elevator_out_of_order")),
      inside_(symbols.Intern("inside")),
      door_shut_(symbols.Intern("door_shut")),
      goal_(symbols.Intern("goal")),
      move_cmd_(symbols.Intern("move_cmd")) {}

void OfficeSensors::Observe(std::uint64_t tick, OfficeState& state, std::span<sdk::Batch> sensors) {
  for (std::size_t port = 0; port < sensors.size(); ++port) {
    sensors[port].updated = first_ || port == kSonar || port == kPose;
    if (sensors[port].updated) sensors[port].facts.clear();
  }
  if (first_) {
    SayRobot(state, sensors[kRobot].facts);
    SayBuilding(state.building, sensors[kBuilding].facts);
  }
  SaySonar(tick, state, sensors[kSonar].facts);
  SayPose(tick, state, sensors[kPose].facts);
  SayPlace(state, sensors[kPlace]);
  SayElevators(state, sensors[kElevators]);
  SayDoors(state, sensors[kDoors]);
  SayGoal(state, sensors[kGoal]);
  SayDestination(state, sensors[kDestination]);
  first_ = false;
}

void OfficeSensors::SaySonar(std::uint64_t tick, OfficeState& state, Facts& facts) const {
  const auto readings =
      state.sonars->Read(state.map(), state.vehicle->pose(), state.people->On(state.floor), tick);
  for (std::size_t n = 0; n < readings.size(); ++n) {
    const Term number = Term::Integer(static_cast<std::int64_t>(n));
    if (std::isfinite(readings[n])) {
      facts.emplace_back(sonar_reading_,
                         std::initializer_list<Term>{number, Term::Real(readings[n])});
    } else {
      facts.emplace_back(no_echo_, std::initializer_list<Term>{number});
    }
  }
}

void OfficeSensors::SayRobot(const OfficeState& state, Facts& facts) const {
  for (int n = 0; n < state.sonars->size(); ++n) {
    facts.push_back(
        Fact(sonar_direction_, {Term::Integer(n), Term::Real(state.sonars->BearingOf(n))}));
  }
  facts.push_back(Fact(robot_radius_, {Term::Real(state.radius)}));
}

void OfficeSensors::SayPose(std::uint64_t tick, OfficeState& state, Facts& facts) const {
  const Vehicle& vehicle = *state.vehicle;
  const Pose pose = state.odometry->Read(vehicle.pose(), vehicle.travelled(), tick);
  facts.push_back(Fact(curr_location_, {Term::Real(pose.x), Term::Real(pose.y)}));
  facts.push_back(Fact(curr_heading_, {Term::Real(pose.heading)}));
  facts.push_back(Fact(curr_floor_, {FloorNumber(state.building, state.floor)}));
}

void OfficeSensors::SayPlace(const OfficeState& state, sdk::Batch& batch) {
  const auto place = state.tracker.current();
  if (!first_ && place == said_place_) return;
  said_place_ = place;
  batch.updated = true;
  batch.facts.clear();
  if (place) batch.facts.push_back(Fact(curr_landmark_, {NameOf(state.building, *place)}));
}

void OfficeSensors::SayBuilding(const Building& building, Facts& facts) const {
  for (const Landmark& landmark : building.landmarks) {
    facts.push_back(
        Fact(landmark_, {Term::Constant(landmark.name), FloorNumber(building, landmark.floor),
                         Term::Real(landmark.place.x), Term::Real(landmark.place.y)}));
  }
  for (const Edge& edge : building.edges) {
    facts.push_back(Fact(adjacent_, {NameOf(building, edge.a), NameOf(building, edge.b)}));
    facts.push_back(Fact(adjacent_, {NameOf(building, edge.b), NameOf(building, edge.a)}));
  }
  for (const ElevatorShaft& shaft : building.elevators) {
    const Term name = Term::Constant(shaft.name);
    facts.push_back(Fact(elevator_, {name}));
    for (std::size_t floor = 0; floor < shaft.lobbies.size(); ++floor) {
      facts.push_back(Fact(elevator_front_, {name, NameOf(building, shaft.lobbies[floor]),
                                             FloorNumber(building, static_cast<int>(floor))}));
    }
    facts.push_back(Fact(cab_, {name, NameOf(building, shaft.cab_landmark)}));
  }
}

void OfficeSensors::SayElevators(const OfficeState& state, sdk::Batch& batch) {
  const auto cab_of_robot = CabAt(state.building, PointOf(state.vehicle->pose()));
  cabs_.clear();
  for (std::size_t i = 0; i < state.elevators.size(); ++i) {
    const Elevator& elevator = state.elevators[i];
    cabs_.push_back({elevator.floor(), elevator.door() == Elevator::Door::kOpen,
                     elevator.in_service(), cab_of_robot == i});
  }
  if (!first_ && cabs_ == said_cabs_) return;
  said_cabs_ = cabs_;
  batch.updated = true;
  batch.facts.clear();
  for (std::size_t i = 0; i < cabs_.size(); ++i) {
    const Term name = Term::Constant(state.building.elevators[i].name);
    const Cab& cab = cabs_[i];
    batch.facts.push_back(Fact(elevator_at_, {name, FloorNumber(state.building, cab.floor)}));
    if (cab.open) batch.facts.push_back(Fact(elevator_open_, {name}));
    if (!cab.in_service) batch.facts.push_back(Fact(elevator_out_of_order_, {name}));
    if (cab.inside) batch.facts.push_back(Fact(inside_, {name}));
  }
}

void OfficeSensors::SayDoors(const OfficeState& state, sdk::Batch& batch) {
  said_shut_.resize(state.doors.size(), 0);
  bool changed = first_;
  for (std::size_t i = 0; i < state.doors.size(); ++i) {
    const char shut = state.doors[i].shut ? 1 : 0;
    changed = changed || shut != said_shut_[i];
    said_shut_[i] = shut;
  }
  if (!changed) return;
  batch.updated = true;
  batch.facts.clear();
  for (std::size_t i = 0; i < state.doors.size(); ++i) {
    if (said_shut_[i] == 0) continue;
    batch.facts.push_back(Fact(door_shut_, {Term::Constant(state.building.doors[i].name)}));
  }
}

void OfficeSensors::SayGoal(const OfficeState& state, sdk::Batch& batch) {
  if (!first_ && state.goal == said_goal_) return;
  said_goal_ = state.goal;
  batch.updated = true;
  batch.facts.clear();
  if (state.goal) batch.facts.push_back(Fact(goal_, {NameOf(state.building, *state.goal)}));
}

void OfficeSensors::SayDestination(const OfficeState& state, sdk::Batch& batch) {
  if (!state.destinations) return;
  if (!first_ && state.destinations->version() == said_destination_) return;
  said_destination_ = state.destinations->version();
  batch.updated = true;
  batch.facts.clear();
  const auto place = state.destinations->current();
  if (place) batch.facts.push_back(Fact(move_cmd_, {Term::Real(place->x), Term::Real(place->y)}));
}

}  // namespace latchwork::office
