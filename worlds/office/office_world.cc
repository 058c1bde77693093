// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/office_world.h"

#include <fmt/format.h>

#include "worlds/office/make_office.h"
#include "worlds/office/office_events.h"

namespace latchwork::office {

namespace {

constexpr std::size_t kRouteEvery = 3;  // ticks
constexpr std::size_t kMaxRoute = 200000;

}  // namespace

OfficeWorld::OfficeWorld()
    : contract_(OfficeContract()), parameters_(OfficeParameters()), events_(OfficeEvents()) {}

logic::Diagnostics OfficeWorld::Load(const sdk::WorldSetup& setup,
                                     const sdk::Parameters& parameters) {
  MadeOffice made = MakeOffice(setup, parameters);
  if (!made.diagnostics.empty()) return std::move(made.diagnostics);
  state_ = std::move(made.state);
  sensors_.emplace(*setup.symbols);
  effectors_.emplace(*setup.symbols);
  tick_seconds_ = setup.tick_seconds;
  drive_for_ = parameters.Real("drive_for");
  end_at_collision_ = parameters.Boolean("end_at_collision");
  touching_ = false;
  counts_ = {};
  outcome_ = {};
  state_->record.route.reserve(4096);
  state_->record.people.reserve(4096);
  state_->record.remarks.reserve(64);
  return {};
}

void OfficeWorld::Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) {
  sensors_->Observe(tick, *state_, sensors);
}

void OfficeWorld::Apply(std::uint64_t /*tick*/, std::span<const sdk::Batch> effectors) {
  effectors_->Apply(effectors, *state_);
}

void OfficeWorld::Step(std::uint64_t tick) {
  if (outcome_.state != sdk::Outcome::State::kRunning) return;
  ++counts_.ticks;
  StepElevators(tick);
  state_->ShutWaitingDoors();
  state_->people->Step(tick, state_->maps, state_->floor, {state_->place(), state_->radius});
  MoveRobot(tick);
  state_->tracker.Update(state_->floor, state_->place());
  if (state_->destinations) state_->destinations->Update(state_->map(), state_->place());
  Remember(tick);
  if (outcome_.state == sdk::Outcome::State::kRunning) CheckGoal();
  if (outcome_.state == sdk::Outcome::State::kRunning) CheckTime();
}

void OfficeWorld::StepElevators(std::uint64_t tick) {
  const Point place = state_->place();
  for (std::size_t i = 0; i < state_->elevators.size(); ++i) {
    Elevator& elevator = state_->elevators[i];
    const ElevatorShaft& shaft = state_->building.elevators[i];
    const bool same_floor = elevator.floor() == state_->floor;
    const bool curtain = same_floor && Distance(place, shaft.door) < state_->reach();
    const bool inside = same_floor && shaft.cab.Contains(place);
    if (!elevator.Step(tick, curtain, inside) || !inside) continue;
    ++counts_.rides;
    state_->Remark(tick, fmt::format("{} carries the robot", shaft.name.name()));
    state_->floor = elevator.floor();
  }
  state_->SyncElevatorLeaves();
}

void OfficeWorld::MoveRobot(std::uint64_t tick) {
  const auto contact = state_->vehicle->Step(state_->map(), state_->people->On(state_->floor));
  if (contact && !touching_) Collide(tick, *contact);
  touching_ = contact.has_value();
}

void OfficeWorld::Collide(std::uint64_t tick, const Contact& contact) {
  ++counts_.collisions;
  state_->Remark(tick, "collision with " + contact.with);
  if (!end_at_collision_) return;
  const int floor = state_->building.floors[static_cast<std::size_t>(state_->floor)].number;
  outcome_ = {sdk::Outcome::State::kFailed,
              fmt::format("collision with {} on floor {} at {:.2f}, {:.2f}", contact.with, floor,
                          contact.place.x, contact.place.y)};
}

void OfficeWorld::Remember(std::uint64_t tick) {
  Record& record = state_->record;
  const bool over = outcome_.state != sdk::Outcome::State::kRunning;
  if (tick % kRouteEvery != 0 && !over) return;
  if (record.route.size() < kMaxRoute) {
    record.route.push_back({state_->floor, state_->place(), tick});
  }
  if (tick % (5 * kRouteEvery) != 0 || record.people.size() >= kMaxRoute) return;
  for (std::size_t floor = 0; floor < state_->maps.size(); ++floor) {
    for (const Disc& person : state_->people->On(static_cast<int>(floor))) {
      record.people.push_back({static_cast<int>(floor), person.centre, tick});
    }
  }
}

void OfficeWorld::CheckGoal() {
  if (!state_->goal) return;
  const Landmark& goal = state_->building.landmarks[*state_->goal];
  if (goal.floor != state_->floor || Distance(goal.place, state_->place()) > goal.zone) return;
  outcome_ = {sdk::Outcome::State::kReached, fmt::format("reached {}", goal.name.name())};
}

void OfficeWorld::CheckTime() {
  if (drive_for_ <= 0.0 || Seconds() < drive_for_ - tick_seconds_ / 2) return;
  if (counts_.collisions == 0) {
    outcome_ = {sdk::Outcome::State::kReached,
                fmt::format("drove for {} s without a collision", drive_for_)};
  } else {
    outcome_ = {sdk::Outcome::State::kFailed,
                fmt::format("drove for {} s with {} collisions", drive_for_, counts_.collisions)};
  }
}

logic::Diagnostics OfficeWorld::HandleEvent(std::uint64_t tick, const logic::Fact& event) {
  std::string error = ApplyEvent(event, events_, *state_);
  if (!error.empty()) return {{{}, std::move(error), {}, {}}};
  state_->Remark(tick, logic::ToString(event));
  return {};
}

std::vector<std::pair<std::string, double>> OfficeWorld::Measures() const {
  const auto reached = state_->destinations ? state_->destinations->reached() : 0;
  return {{"collisions", static_cast<double>(counts_.collisions)},
          {"time_s", Seconds()},
          {"distance_m", state_->vehicle->travelled()},
          {"floors_ridden", static_cast<double>(counts_.rides)},
          {"destinations_reached", static_cast<double>(reached)}};
}

std::vector<std::filesystem::path> OfficeWorld::Draw(const std::filesystem::path& folder) const {
  PictureScene scene;
  scene.building = &state_->building;
  scene.record = &state_->record;
  scene.tick_seconds = tick_seconds_;
  for (const Leaf& leaf : state_->doors) scene.shut_doors.push_back(leaf.shut ? 1 : 0);
  if (state_->goal) {
    const Landmark& goal = state_->building.landmarks[*state_->goal];
    scene.goal_floor = goal.floor;
    scene.goal = goal.place;
  }
  std::vector<std::filesystem::path> written = DrawFloors(scene, folder);
  for (const auto& svg : {DrawRoute(scene, folder), DrawPlans(scene, folder)}) {
    written.insert(written.end(), svg.begin(), svg.end());
  }
  return written;
}

}  // namespace latchwork::office
