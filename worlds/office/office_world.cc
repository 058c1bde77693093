// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/office_world.h"

#include <algorithm>
#include <cmath>

namespace latchwork::office {

namespace {

using logic::Fact;
using logic::Symbol;
using logic::Term;

constexpr double kCurtain = 0.15;       // beyond the robot's rim, m
constexpr double kSeesDoors = 2.5;      // m
constexpr std::size_t kRouteEvery = 3;  // ticks
constexpr std::size_t kMaxRoute = 200000;

std::string Name(logic::Symbol symbol) { return std::string(symbol.name()); }

}  // namespace

OfficeWorld::OfficeWorld()
    : contract_(OfficeContract()), parameters_(OfficeParameters()), events_(OfficeEvents()) {}

logic::Diagnostics OfficeWorld::Load(const sdk::WorldSetup& setup,
                                     const sdk::Parameters& parameters) {
  MadeOffice made = MakeOffice(setup, parameters);
  if (!made.diagnostics.empty()) return std::move(made.diagnostics);
  state_ = std::move(made.state);
  tick_seconds_ = setup.tick_seconds;
  end_at_collision_ = parameters.Boolean("end_at_collision");
  outcome_ = {};
  collisions_ = rides_ = 0;
  touching_ = false;
  last_turn_.reset();
  destinations_.reset();
  if (parameters.Boolean("destinations")) {
    destinations_.emplace(setup.seed, state_->radius, tick_seconds_);
  }
  symbols_ = setup.symbols;
  InternWords(*setup.symbols);
  state_->record.route.reserve(4096);
  state_->record.people.reserve(4096);
  state_->record.remarks.reserve(64);
  return {};
}

void OfficeWorld::InternWords(logic::SymbolTable& symbols) {
  const auto intern = [&](const char* name) { return symbols.Intern(name); };
  sonar_reading_ = intern("sonar_reading");
  no_echo_ = intern("no_echo");
  curr_location_ = intern("curr_location");
  curr_heading_ = intern("curr_heading");
  curr_landmark_ = intern("curr_landmark");
  curr_floor_ = intern("curr_floor");
  elevator_at_ = intern("elevator_at");
  elevator_door_ = intern("elevator_door");
  elevator_moving_ = intern("elevator_moving");
  elevator_open_ = intern("elevator_open");
  elevator_out_of_order_ = intern("elevator_out_of_order");
  inside_ = intern("inside");
  out_of_order_ = intern("out_of_order");
  door_shut_ = intern("door_shut");
  goal_ = intern("goal");
  fwd_ = intern("fwd");
  turn_ = intern("turn");
  halt_ = intern("halt");
  call_ = intern("call");
  ride_ = intern("ride");
  move_cmd_ = intern("move_cmd");
  door_states_.clear();
  for (const auto door : {Elevator::Door::kClosed, Elevator::Door::kOpening, Elevator::Door::kOpen,
                          Elevator::Door::kClosing}) {
    door_states_.push_back(symbols.Intern(NameOf(door)));
  }
}

void OfficeWorld::Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) {
  for (sdk::Batch& batch : sensors) {
    batch.updated = true;
    batch.facts.clear();
  }
  sensors[kRobot].updated = sensors[kBuilding].updated = tick == 0;
  if (tick == 0) {
    ObserveRobot(sensors[kRobot].facts);
    ObserveBuilding(sensors[kBuilding].facts);
  }
  ObserveDestination(tick, sensors[kDestination].facts);
  ObserveSonar(tick, sensors[kSonar].facts);
  const Vehicle& vehicle = *state_->vehicle;
  const Pose pose = state_->odometry->Read(vehicle.pose(), vehicle.travelled(), tick);
  sensors[kPose].facts.emplace_back(Fact(curr_location_, {Term::Real(pose.x), Term::Real(pose.y)}));
  sensors[kPose].facts.emplace_back(Fact(curr_heading_, {Term::Real(pose.heading)}));
  ObservePlace(sensors[kPlace].facts);
  ObserveElevators(sensors[kElevators].facts);
  ObserveDoors(sensors[kDoors].facts);
  if (state_->goal) {
    const auto& landmark = state_->building.landmarks[*state_->goal];
    sensors[kGoal].facts.emplace_back(Fact(goal_, {Term::Constant(landmark.name)}));
  }
}

void OfficeWorld::ObserveSonar(std::uint64_t tick, std::vector<Fact>& facts) {
  const auto readings = state_->sonars->Read(state_->map(), state_->vehicle->pose(),
                                             state_->people->On(state_->floor), tick);
  for (std::size_t n = 0; n < readings.size(); ++n) {
    const Term number = Term::Integer(static_cast<std::int64_t>(n));
    if (std::isfinite(readings[n])) {
      facts.emplace_back(Fact(sonar_reading_, {number, Term::Real(readings[n])}));
    } else {
      facts.emplace_back(Fact(no_echo_, {number}));
    }
  }
}

void OfficeWorld::ObservePlace(std::vector<Fact>& facts) const {
  const Building& building = state_->building;
  if (const auto landmark = state_->tracker.current()) {
    facts.emplace_back(Fact(curr_landmark_, {Term::Constant(building.landmarks[*landmark].name)}));
  }
  const int number = building.floors[static_cast<std::size_t>(state_->floor)].number;
  facts.emplace_back(Fact(curr_floor_, {Term::Integer(number)}));
}

void OfficeWorld::ObserveElevators(std::vector<Fact>& facts) const {
  const Building& building = state_->building;
  for (std::size_t i = 0; i < state_->elevators.size(); ++i) {
    const Elevator& elevator = state_->elevators[i];
    const Term name = Term::Constant(building.elevators[i].name);
    const int number = building.floors[static_cast<std::size_t>(elevator.floor())].number;
    facts.emplace_back(Fact(elevator_at_, {name, Term::Integer(number)}));
    const auto door = static_cast<std::size_t>(elevator.door());
    facts.emplace_back(Fact(elevator_door_, {name, Term::Constant(door_states_[door])}));
    if (elevator.is_moving()) facts.emplace_back(Fact(elevator_moving_, {name}));
    if (!elevator.in_service()) {
      facts.emplace_back(Fact(out_of_order_, {name}));
      facts.emplace_back(Fact(elevator_out_of_order_, {name}));
    }
    if (elevator.door() == Elevator::Door::kOpen) facts.emplace_back(Fact(elevator_open_, {name}));
  }
  if (const auto cab = CabAt(building, PointOf(state_->vehicle->pose()))) {
    facts.emplace_back(Fact(inside_, {Term::Constant(building.elevators[*cab].name)}));
  }
}

void OfficeWorld::ObserveDoors(std::vector<Fact>& facts) {
  const Building& building = state_->building;
  const Point place = PointOf(state_->vehicle->pose());
  for (std::size_t i = 0; i < building.doors.size(); ++i) {
    const Door& door = building.doors[i];
    if (door.floor == state_->floor && Distance(place, door.leaf) < kSeesDoors) {
      state_->seen_shut[i] = state_->doors[i].shut ? 1 : 0;
    }
    if (state_->seen_shut[i] == 0) continue;
    facts.emplace_back(Fact(door_shut_, {Term::Constant(door.name)}));
  }
}

void OfficeWorld::ObserveRobot(std::vector<Fact>& facts) const {
  const Symbol sonar_direction = symbols_->Intern("sonar_direction");
  for (int n = 0; n < state_->sonars->size(); ++n) {
    facts.emplace_back(
        Fact(sonar_direction, {Term::Integer(n), Term::Real(state_->sonars->BearingOf(n))}));
  }
  facts.emplace_back(Fact(symbols_->Intern("robot_radius"), {Term::Real(state_->radius)}));
}

void OfficeWorld::ObserveBuilding(std::vector<Fact>& facts) const {
  const Building& building = state_->building;
  const auto number = [&](int floor) {
    return Term::Integer(floor < 0 ? 0 : building.floors[static_cast<std::size_t>(floor)].number);
  };
  const auto name = [&](std::size_t landmark) {
    return Term::Constant(building.landmarks[landmark].name);
  };
  for (const Landmark& landmark : building.landmarks) {
    facts.emplace_back(Fact(symbols_->Intern("landmark"),
                            {Term::Constant(landmark.name), number(landmark.floor),
                             Term::Real(landmark.place.x), Term::Real(landmark.place.y)}));
  }
  const Symbol adjacent = symbols_->Intern("adjacent");
  for (const Edge& edge : building.edges) {
    facts.emplace_back(Fact(adjacent, {name(edge.a), name(edge.b)}));
    facts.emplace_back(Fact(adjacent, {name(edge.b), name(edge.a)}));
  }
  for (const ElevatorShaft& shaft : building.elevators) {
    const Term elevator = Term::Constant(shaft.name);
    facts.emplace_back(Fact(symbols_->Intern("elevator"), {elevator}));
    facts.emplace_back(Fact(symbols_->Intern("cab"), {elevator, name(shaft.cab_landmark)}));
    for (std::size_t floor = 0; floor < shaft.lobbies.size(); ++floor) {
      facts.emplace_back(
          Fact(symbols_->Intern("elevator_front"),
               {elevator, name(shaft.lobbies[floor]), number(static_cast<int>(floor))}));
    }
  }
}

void OfficeWorld::ObserveDestination(std::uint64_t tick, std::vector<Fact>& facts) {
  if (!destinations_) return;
  const Point place = destinations_->At(tick, state_->map(), PointOf(state_->vehicle->pose()));
  facts.emplace_back(Fact(move_cmd_, {Term::Real(place.x), Term::Real(place.y)}));
}

void OfficeWorld::Apply(std::uint64_t /*tick*/, std::span<const sdk::Batch> effectors) {
  Drive(effectors[kDrive]);
  PressButtons(effectors[kElevatorButtons]);
}

void OfficeWorld::Drive(const sdk::Batch& batch) {
  std::optional<double> speed;
  std::optional<double> turn;
  bool halt = false;
  for (const Fact& fact : batch.facts) {
    if (fact.predicate() == halt_) halt = true;
    if (fact.arity() != 1 || !fact.argument(0).is_number()) continue;
    const double value = fact.argument(0).number();
    if (!std::isfinite(value)) continue;
    // Several commands of a kind: the slowest, the smallest turn.
    if (fact.predicate() == fwd_ && (!speed || value < *speed)) speed = value;
    if (fact.predicate() == turn_ && (!turn || std::abs(value) < std::abs(*turn))) turn = value;
  }
  Vehicle& vehicle = *state_->vehicle;
  vehicle.Forward(halt ? std::optional(0.0) : speed);
  // A turn counts from the heading at which it was told; a batch that merely stands is the same
  // turn.
  if (batch.updated || turn != last_turn_) vehicle.Turn(turn);
  last_turn_ = turn;
}

void OfficeWorld::PressButtons(const sdk::Batch& batch) {
  for (const Fact& fact : batch.facts) {
    if (fact.arity() != 2 || !fact.argument(1).is_number()) continue;
    if (fact.argument(0).kind() != Term::Kind::kConstant) continue;
    const auto elevator = state_->building.FindElevator(fact.argument(0).symbol().name());
    const auto floor =
        state_->building.FindFloor(static_cast<int>(std::lround(fact.argument(1).number())));
    if (!elevator || !floor) continue;
    const bool inside = CabAt(state_->building, PointOf(state_->vehicle->pose())) == elevator;
    Elevator& called = state_->elevators[*elevator];
    if (fact.predicate() == ride_ && inside && *floor != called.floor()) called.Call(*floor);
    if (fact.predicate() == call_) called.Call(*floor);
  }
}

void OfficeWorld::Step(std::uint64_t tick) {
  if (outcome_.state != sdk::Outcome::State::kRunning) return;
  StepElevators(tick);
  const Disc robot{PointOf(state_->vehicle->pose()), state_->radius};
  state_->people->Step(tick, state_->maps, state_->floor, robot);
  MoveRobot(tick);
  state_->tracker.Update(state_->floor, PointOf(state_->vehicle->pose()));
  Remember(tick);
  if (outcome_.state == sdk::Outcome::State::kRunning) CheckGoal();
}

void OfficeWorld::StepElevators(std::uint64_t tick) {
  const Building& building = state_->building;
  const Point place = PointOf(state_->vehicle->pose());
  for (std::size_t i = 0; i < state_->elevators.size(); ++i) {
    Elevator& elevator = state_->elevators[i];
    const ElevatorShaft& shaft = building.elevators[i];
    const bool same_floor = elevator.floor() == state_->floor;
    const bool curtain = same_floor && Distance(place, shaft.door) < state_->radius + kCurtain;
    const bool inside = same_floor && shaft.cab.Contains(place);
    if (!elevator.Step(tick, curtain, inside) || !inside) continue;
    ++rides_;
    Remark(tick, Name(shaft.name) + " carries the robot");
    state_->floor = elevator.floor();
  }
  state_->SyncElevatorLeaves();
}

void OfficeWorld::MoveRobot(std::uint64_t tick) {
  const auto contact = state_->vehicle->Step(state_->map(), state_->people->On(state_->floor));
  if (contact && !touching_) {
    ++collisions_;
    Remark(tick, "collision with " + contact->with);
    if (end_at_collision_) {
      const int number = state_->building.floors[static_cast<std::size_t>(state_->floor)].number;
      outcome_ = {sdk::Outcome::State::kFailed,
                  "collision with " + contact->with + " on floor " + std::to_string(number) +
                      " at " + logic::ToString(Term::Real(contact->place.x)) + ", " +
                      logic::ToString(Term::Real(contact->place.y))};
    }
  }
  touching_ = contact.has_value();
}

void OfficeWorld::Remember(std::uint64_t tick) {
  Record& record = state_->record;
  const bool over = outcome_.state != sdk::Outcome::State::kRunning;
  if (tick % kRouteEvery != 0 && !over) return;
  if (record.route.size() < kMaxRoute) {
    record.route.push_back({state_->floor, PointOf(state_->vehicle->pose()), tick});
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
  const Point place = PointOf(state_->vehicle->pose());
  if (goal.floor != state_->floor || Distance(goal.place, place) > goal.zone) return;
  outcome_ = {sdk::Outcome::State::kReached, "reached " + Name(goal.name)};
}

void OfficeWorld::Remark(std::uint64_t tick, std::string text) {
  state_->record.remarks.push_back(
      {tick, state_->floor, PointOf(state_->vehicle->pose()), std::move(text)});
}

std::string OfficeWorld::SetDoorByEvent(const Fact& event, bool shut) {
  const auto door = state_->building.FindDoor(event.argument(0).symbol().name());
  if (!door) return "the building has no door '" + Name(event.argument(0).symbol()) + "'";
  const Door& place = state_->building.doors[*door];
  const bool in_the_way =
      place.floor == state_->floor &&
      Distance(PointOf(state_->vehicle->pose()), place.leaf) < state_->radius + 0.1;
  if (shut && in_the_way) return "the robot stands in the door '" + Name(place.name) + "'";
  state_->SetDoor(*door, shut);
  return {};
}

std::string OfficeWorld::SetServiceByEvent(const Fact& event, bool in_service) {
  const auto elevator = state_->building.FindElevator(event.argument(0).symbol().name());
  if (!elevator) return "the building has no elevator '" + Name(event.argument(0).symbol()) + "'";
  state_->elevators[*elevator].SetInService(in_service);
  return {};
}

std::string OfficeWorld::PutBox(const Fact& event) {
  const auto floor = state_->building.FindFloor(static_cast<int>(event.argument(0).number()));
  const double half = event.argument(3).number() / 2;
  const double x = event.argument(1).number();
  const double y = event.argument(2).number();
  if (!floor) return "the building has no such floor";
  if (!(half > 0.0 && half <= 2.5)) return "a box measures more than 0 and at most 5 m";
  const Box box{*floor, {x - half, y - half, x + half, y + half}};
  if (*floor == state_->floor &&
      Distance(PointOf(state_->vehicle->pose()), box.area) < state_->radius + 0.02) {
    return "the robot stands where the box is put";
  }
  FloorMap& map = state_->maps[static_cast<std::size_t>(*floor)];
  Cover(map, CellsOf(map, box.area));
  state_->record.boxes.push_back(box);
  return {};
}

std::string OfficeWorld::EventError(const Fact& event, std::uint64_t tick) {
  const auto name = event.predicate().name();
  const auto spec = std::find_if(events_.begin(), events_.end(),
                                 [&](const auto& known) { return known.name == name; });
  if (spec == events_.end() || spec->arguments.size() != event.arity()) {
    return "the office knows no event '" + logic::ToString(event) + "'";
  }
  for (std::size_t i = 0; i < event.arity(); ++i) {
    const Term& term = event.argument(i);
    const bool fits = spec->arguments[i].type == sdk::ArgumentType::kSymbol
                          ? term.kind() == Term::Kind::kConstant
                          : term.is_number() && std::abs(term.number()) < 1e6;
    if (!fits)
      return "argument " + std::to_string(i + 1) + " of '" + Name(event.predicate()) +
             "' must be a " +
             (spec->arguments[i].type == sdk::ArgumentType::kSymbol ? "name" : "number");
  }
  std::string error;
  if (name == "door_shut" || name == "door_opened") {
    error = SetDoorByEvent(event, name == "door_shut");
  } else if (name == "box_put") {
    error = PutBox(event);
  } else {
    error = SetServiceByEvent(event, name == "in_service");
  }
  if (error.empty()) Remark(tick, logic::ToString(event));
  return error;
}

logic::Diagnostics OfficeWorld::HandleEvent(std::uint64_t tick, const Fact& event) {
  std::string error = EventError(event, tick);
  if (error.empty()) return {};
  return {{{}, std::move(error), {}, {}}};
}

std::vector<std::pair<std::string, double>> OfficeWorld::Measures() const {
  return {{"collisions", static_cast<double>(collisions_)},
          {"distance_m", state_->vehicle->travelled()},
          {"floors_ridden", static_cast<double>(rides_)}};
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
  const auto svg = DrawRoute(scene, folder);
  written.insert(written.end(), svg.begin(), svg.end());
  return written;
}

}  // namespace latchwork::office
