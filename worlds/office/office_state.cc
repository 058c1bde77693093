// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/office_state.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <queue>
#include <string_view>
#include <utility>

namespace latchwork::office {

namespace {

constexpr double kLeafThickness = 0.1;
constexpr int kPlaceTries = 20000;

std::vector<std::string_view> Words(std::string_view text, std::string_view separators = " ,\t\n") {
  std::vector<std::string_view> words;
  while (true) {
    const auto first = text.find_first_not_of(separators);
    if (first == std::string_view::npos) return words;
    text.remove_prefix(first);
    const auto end = std::min(text.size(), text.find_first_of(separators));
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

std::optional<double> Number(std::string_view text) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = code == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

template <typename Items>
std::vector<std::string> NamesOf(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.emplace_back(item.name.name());
  return names;
}

/// Sets up one run; each step reports all its mistakes and leaves something harmless behind.
class OfficeMaker {
 public:
  OfficeMaker(const sdk::WorldSetup& setup, const sdk::Parameters& parameters)
      : setup_(setup), parameters_(parameters), random_(setup.seed, "office") {}

  MadeOffice Make() {
    LoadedBuilding loaded = LoadPlan();
    if (!loaded.diagnostics.empty()) return {nullptr, std::move(loaded.diagnostics)};
    made_.state = std::make_unique<OfficeState>(std::move(loaded.building));
    for (const Storey& storey : state().building.floors) state().maps.push_back(storey.map);
    MakeElevators();
    MakeDoors();
    MakeGoal();
    MakeRobot();
    if (!made_.diagnostics.empty()) return std::move(made_);
    ShutDoorsBySeed();
    MakeBoxes();
    MakeInhabitants();
    if (!made_.diagnostics.empty()) made_.state.reset();
    return std::move(made_);
  }

 private:
  OfficeState& state() { return *made_.state; }
  const Building& building() { return made_.state->building; }

  void Fail(std::string_view parameter, std::string message, std::string hint = {}) {
    made_.diagnostics.push_back(
        {parameters_.PlaceOf(parameter), std::move(message), std::move(hint), {}});
  }

  void FailName(std::string_view parameter, std::string_view kind, std::string_view name,
                const std::vector<std::string>& known) {
    const auto near = logic::NearestName(name, known);
    Fail(parameter, "the building has no " + std::string(kind) + " '" + std::string(name) + "'",
         near.empty() ? std::string() : "did you mean '" + std::string(near) + "'?");
  }

  LoadedBuilding LoadPlan() {
    const auto map = parameters_.File("map");
    const auto file = parameters_.File("building");
    if (!map.empty() && !file.empty()) {
      LoadedBuilding both;
      both.diagnostics.push_back(
          {parameters_.PlaceOf("map"), "both a building and a map are given", "leave one out", {}});
      return both;
    }
    if (!map.empty()) {
      return ReadBareMap(map, parameters_.Real("resolution"), parameters_.PlaceOf("map"));
    }
    return ReadBuilding(file.empty() ? ShippedBuilding() : file, *setup_.symbols);
  }

  std::filesystem::path ShippedBuilding() const {
    const auto nested = setup_.data / "data" / "building" / "building.p";
    std::error_code code;
    return std::filesystem::exists(nested, code) ? nested : setup_.data / "building" / "building.p";
  }

  void MakeElevators() {
    const ElevatorOptions options{
        parameters_.Real("elevator_door_time"), parameters_.Real("elevator_dwell_time"),
        parameters_.Real("elevator_floor_time"), parameters_.Real("elevator_calls")};
    const auto floors = Words(parameters_.Text("elevator_floors"));
    const std::size_t count = building().floors.size();
    for (std::size_t i = 0; i < building().elevators.size(); ++i) {
      const ElevatorShaft& shaft = building().elevators[i];
      state().elevators.emplace_back(options, static_cast<int>(count), setup_.tick_seconds,
                                     setup_.seed, shaft.name.name());
      state().elevators.back().PutAt(i < floors.size()
                                         ? FloorNamed("elevator_floors", floors[i])
                                         : static_cast<int>(random_.Index(count, 1, i)));
      auto& leaves = state().elevator_leaves.emplace_back();
      for (const FloorMap& map : state().maps) {
        leaves.push_back({CellsOf(map, shaft.door, kLeafThickness), false});
      }
    }
    state().SyncElevatorLeaves();
  }

  int FloorNamed(std::string_view parameter, std::string_view word) {
    const auto number = Number(word);
    const auto floor = number ? building().FindFloor(static_cast<int>(*number)) : std::nullopt;
    if (!floor) Fail(parameter, "the building has no floor '" + std::string(word) + "'");
    return floor.value_or(0);
  }

  void MakeDoors() {
    for (const Door& door : building().doors) {
      const FloorMap& map = state().maps[static_cast<std::size_t>(door.floor)];
      state().doors.push_back({CellsOf(map, door.leaf, kLeafThickness), false});
    }
    state().seen_shut.assign(building().doors.size(), 0);
    for (const auto word : Words(parameters_.Text("shut"))) {
      const auto door = building().FindDoor(word);
      if (door) {
        state().SetDoor(*door, true);
      } else {
        FailName("shut", "door", word, NamesOf(building().doors));
      }
    }
  }

  void MakeGoal() {
    const std::string& name = parameters_.Text("goal");
    if (name.empty()) return;
    state().goal = building().FindLandmark(name);
    if (!state().goal) FailName("goal", "landmark", name, NamesOf(building().landmarks));
  }

  void MakeRobot() {
    VehicleOptions options;
    options.max_speed = parameters_.Real("max_speed");
    state().radius = options.radius;
    state().vehicle.emplace(options, setup_.tick_seconds);
    Pose pose = StartPlace();
    pose.heading = StartHeading();
    const auto& map = state().map();
    if (made_.diagnostics.empty() && FindContact(map, PointOf(pose), options.radius)) {
      Fail("start", "the robot has no room at its start");
    }
    state().vehicle->Place(pose);
  }

  double StartHeading() {
    const std::string& text = parameters_.Text("start_heading");
    if (text.empty()) return random_.Between(-std::numbers::pi, std::numbers::pi, 2, 0);
    const auto heading = Number(text);
    if (!heading) Fail("start_heading", "'" + text + "' is not a number of radians");
    return heading.value_or(0.0);
  }

  Pose StartPlace() {
    const std::string& name = parameters_.Text("start");
    if (name == "pose") {
      const auto number = parameters_.Integer("start_floor");
      const auto floor =
          number == 0 ? std::optional(0) : building().FindFloor(static_cast<int>(number));
      if (!floor) Fail("start_floor", "the building has no floor " + std::to_string(number));
      state().floor = floor.value_or(0);
      return {parameters_.Real("start_x"), parameters_.Real("start_y"), 0.0};
    }
    if (!name.empty()) {
      const auto landmark = building().FindLandmark(name);
      if (landmark && building().landmarks[*landmark].floor >= 0) return NearLandmark(*landmark);
      FailName("start", "landmark", name, NamesOf(building().landmarks));
      return {};
    }
    return building().rooms.empty() ? AnyFreePlace() : AnyRoom();
  }

  Pose NearLandmark(std::size_t index) {
    const Landmark& landmark = building().landmarks[index];
    state().floor = landmark.floor;
    const double spread = parameters_.Real("start_spread");
    for (std::uint64_t i = 0; spread > 0.0 && i < 200; ++i) {
      const double way = spread * std::sqrt(random_.Uniform(3, 2 * i));
      const double angle = random_.Between(-std::numbers::pi, std::numbers::pi, 3, 2 * i + 1);
      const Point place{landmark.place.x + way * std::cos(angle),
                        landmark.place.y + way * std::sin(angle)};
      if (IsLineFree(state().map(), landmark.place, place, state().radius + 0.15)) {
        return {place.x, place.y, 0.0};
      }
    }
    return {landmark.place.x, landmark.place.y, 0.0};
  }

  Pose AnyRoom() {
    const auto floor = building().FindFloor(static_cast<int>(parameters_.Integer("start_floor")));
    std::vector<std::size_t> landmarks;
    for (const Room& room : building().rooms) {
      const auto landmark = building().FindLandmark(room.name.name());
      if (landmark && (!floor || room.floor == *floor)) landmarks.push_back(*landmark);
    }
    if (landmarks.empty()) return AnyFreePlace();
    return NearLandmark(landmarks[random_.Index(landmarks.size(), 4)]);
  }

  /// On a bare map: a place with some room around it, in a region that is more than a pocket.
  Pose AnyFreePlace() {
    const FloorMap& map = state().map();
    for (std::uint64_t i = 0; i < kPlaceTries; ++i) {
      const Point place{
          map.origin().x + map.width() * map.resolution() * random_.Uniform(5, 2 * i),
          map.origin().y + map.height() * map.resolution() * random_.Uniform(5, 2 * i + 1)};
      if (FindContact(map, place, state().radius + 0.25)) continue;
      if (IsRoomy(map, place)) return {place.x, place.y, 0.0};
    }
    Fail("map", "the map has no free place for the robot");
    return {};
  }

  bool IsRoomy(const FloorMap& map, Point from) const {
    constexpr double kStep = 0.25;
    constexpr std::size_t kEnough = 160;  // steps of a quarter metre: ten square metres
    std::queue<std::pair<int, int>> open;
    std::vector<std::pair<int, int>> seen{{0, 0}};
    open.emplace(0, 0);
    while (!open.empty() && seen.size() < kEnough) {
      const auto [x, y] = open.front();
      open.pop();
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const std::pair next{x + dx, y + dy};
        if (std::find(seen.begin(), seen.end(), next) != seen.end()) continue;
        const Point a{from.x + x * kStep, from.y + y * kStep};
        const Point b{from.x + next.first * kStep, from.y + next.second * kStep};
        if (!IsLineFree(map, a, b, made_.state->radius)) continue;
        seen.push_back(next);
        open.push(next);
      }
    }
    return seen.size() >= kEnough;
  }

  void ShutDoorsBySeed() {
    auto wanted = parameters_.Integer("shut_doors");
    std::vector<std::size_t> order(building().doors.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[random_.Index(i, 6, i)]);
    }
    state().tracker.Reset(state().maps, state().floor, PointOf(state().vehicle->pose()),
                          state().radius);
    for (const std::size_t door : order) {
      if (wanted == 0) break;
      if (state().doors[door].shut || IsInDoor(door)) continue;
      state().SetDoor(door, true);
      if (IsGoalLinked()) {
        --wanted;
      } else {
        state().SetDoor(door, false);
      }
    }
  }

  bool IsInDoor(std::size_t door) {
    const Door& d = building().doors[door];
    return d.floor == state().floor &&
           Distance(PointOf(state().vehicle->pose()), d.leaf) < state().radius + 0.2;
  }

  /// Whether a way of landmarks leads to the goal without a shut door. Elevators link their
  /// lobbies.
  bool IsGoalLinked() {
    const auto start = state().tracker.current();
    if (!state().goal || !start) return true;
    std::vector<char> seen(building().landmarks.size(), 0);
    for (const Door& door : building().doors) {
      const auto index = building().FindLandmark(door.name.name());
      const auto place = static_cast<std::size_t>(&door - building().doors.data());
      if (index && state().doors[place].shut) seen[*index] = 1;
    }
    std::vector<std::size_t> open{*start};
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      if (at == *state().goal) return true;
      if (seen[at] != 0) continue;
      seen[at] = 1;
      for (const Edge& edge : building().edges) {
        if (edge.a == at) open.push_back(edge.b);
        if (edge.b == at) open.push_back(edge.a);
      }
      for (const ElevatorShaft& shaft : building().elevators) {
        if (std::find(shaft.lobbies.begin(), shaft.lobbies.end(), at) == shaft.lobbies.end()) {
          continue;
        }
        open.insert(open.end(), shaft.lobbies.begin(), shaft.lobbies.end());
      }
    }
    return false;
  }

  void MakeBoxes() {
    for (const auto text : Words(parameters_.Text("box"), ";")) AddDeclaredBox(text);
    const Point place = PointOf(state().vehicle->pose());
    const auto count = static_cast<int>(parameters_.Integer("boxes"));
    for (const Box& box : PlaceBoxes(building(), count, setup_.seed, state().floor, place)) {
      AddBox(box);
    }
  }

  void AddDeclaredBox(std::string_view text) {
    std::vector<double> numbers;
    for (const auto word : Words(text)) {
      if (const auto number = Number(word)) numbers.push_back(*number);
    }
    if (numbers.size() != 5 || Words(text).size() != 5 || numbers[3] <= 0 || numbers[4] <= 0) {
      return Fail("box", "'" + std::string(text) + "' is not 'floor x y width depth'");
    }
    const auto floor = building().FindFloor(static_cast<int>(numbers[0]));
    if (!floor) return Fail("box", "a box stands on a floor that does not exist");
    const Box box{*floor,
                  {numbers[1], numbers[2], numbers[1] + numbers[3], numbers[2] + numbers[4]}};
    const bool on_robot = *floor == state().floor &&
                          Distance(PointOf(state().vehicle->pose()), box.area) < state().radius;
    if (on_robot) return Fail("box", "a box stands where the robot starts");
    AddBox(box);
  }

  void AddBox(const Box& box) {
    FloorMap& map = state().maps[static_cast<std::size_t>(box.floor)];
    Cover(map, CellsOf(map, box.area));
    state().record.boxes.push_back(box);
  }

  void MakeInhabitants() {
    const Point place = PointOf(state().vehicle->pose());
    PeopleOptions people;
    people.count = static_cast<int>(parameters_.Integer("people"));
    state().people.emplace(people, building(), setup_.tick_seconds, setup_.seed, state().floor,
                           place);
    state().odometry.emplace(parameters_.Real("odometry_noise"), setup_.seed);
    SonarOptions sonar;
    sonar.count = static_cast<int>(parameters_.Integer("sonars"));
    sonar.cone = parameters_.Real("sonar_cone") * std::numbers::pi / 180.0;
    sonar.rays = static_cast<int>(parameters_.Integer("sonar_rays"));
    sonar.max_range = parameters_.Real("sonar_range");
    sonar.min_range = std::min(parameters_.Real("sonar_min_range"), sonar.max_range);
    sonar.mount_radius = state().radius;
    sonar.noise = parameters_.Real("sonar_noise");
    sonar.missed = parameters_.Real("sonar_missed");
    state().sonars.emplace(sonar, setup_.seed);
    state().tracker.Reset(state().maps, state().floor, place, state().radius);
  }

  const sdk::WorldSetup& setup_;
  const sdk::Parameters& parameters_;
  sdk::RandomStream random_;
  MadeOffice made_;
};

}  // namespace

void OfficeState::SetDoor(std::size_t door, bool shut) {
  Leaf& leaf = doors[door];
  if (leaf.shut == shut) return;
  leaf.shut = shut;
  FloorMap& map_of_door = maps[static_cast<std::size_t>(building.doors[door].floor)];
  if (shut) {
    Cover(map_of_door, leaf.cells);
  } else {
    Uncover(map_of_door, leaf.cells);
  }
}

void OfficeState::SyncElevatorLeaves() {
  for (std::size_t e = 0; e < elevators.size(); ++e) {
    for (std::size_t f = 0; f < maps.size(); ++f) {
      Leaf& leaf = elevator_leaves[e][f];
      const bool here = static_cast<int>(f) == elevators[e].floor();
      const bool shut = !here || elevators[e].is_shut();
      if (leaf.shut == shut) continue;
      leaf.shut = shut;
      if (shut) {
        Cover(maps[f], leaf.cells);
      } else {
        Uncover(maps[f], leaf.cells);
      }
    }
  }
}

MadeOffice MakeOffice(const sdk::WorldSetup& setup, const sdk::Parameters& parameters) {
  return OfficeMaker(setup, parameters).Make();
}

}  // namespace latchwork::office
