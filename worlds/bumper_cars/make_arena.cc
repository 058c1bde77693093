// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/make_arena.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>

#include "latchwork/sdk/random.h"

namespace latchwork::bumper_cars {
namespace {

constexpr double kRoom = 1.6;  // m, around the centre of a car at the start
constexpr std::uint64_t kTries = 200;

constexpr std::array<std::string_view, 24> kPeople{
    "anna", "bob",  "carl", "dora", "emil",  "fay",  "gus", "hedy", "ivo", "jane", "karl", "lea",
    "max",  "nina", "otto", "pia",  "quinn", "rosa", "sam", "tess", "udo", "vera", "will", "zoe"};

constexpr std::array<Vector, 4> kPolePlaces{
    {{0.3, 0.25}, {0.7, 0.75}, {0.7, 0.25}, {0.3, 0.75}}};  // in parts of the arena

bool HasRoom(Vector place, const Arena& arena) {
  return std::all_of(arena.cars.begin(), arena.cars.end(),
                     [&](const Car& car) { return Length(car.place - place) > kRoom; }) &&
         std::all_of(arena.poles.begin(), arena.poles.end(),
                     [&](const Pole& pole) { return Length(pole.place - place) > kRoom; });
}

Vector FreePlace(const Arena& arena, const sdk::RandomStream& random) {
  Vector place;
  for (std::uint64_t i = 0; i < kTries; ++i) {
    place = {random.Between(1, arena.size.x - 1, arena.cars.size(), 3 * i),
             random.Between(1, arena.size.y - 1, arena.cars.size(), 3 * i + 1)};
    if (HasRoom(place, arena)) break;
  }
  return place;
}

}  // namespace

Arena MakeArena(const sdk::Parameters& parameters, std::uint64_t seed) {
  const sdk::RandomStream random(seed, "start");
  Arena arena;
  arena.size = {parameters.Real("width"), parameters.Real("height")};
  arena.gate = {1.2, arena.size.y / 2};
  for (std::int64_t i = 0; i < parameters.Integer("poles"); ++i) {
    const Vector part = kPolePlaces.at(static_cast<std::size_t>(i));
    arena.poles.push_back(
        {fmt::format("pole{}", i + 1), {part.x * arena.size.x, part.y * arena.size.y}});
  }
  Car car;
  car.full_charge = parameters.Real("charge");
  const auto add = [&](Attitude attitude, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) {
      const std::size_t number = arena.cars.size();
      car.name = fmt::format("car{}", number);
      car.driver = kPeople.at(number - 1);
      car.attitude = attitude;
      car.place = FreePlace(arena, random);
      car.heading = random.Between(-std::numbers::pi, std::numbers::pi, number, 2);
      car.charge = car.full_charge * random.Between(0.3, 1, number, 5);
      arena.cars.push_back(car);
    }
  };
  car.name = "me";
  car.driver = "me";
  car.attitude = Attitude::kSelf;
  car.place = arena.gate;
  car.charge = car.full_charge;
  arena.cars.push_back(car);
  add(Attitude::kEnemy, parameters.Integer("enemies"));
  add(Attitude::kFriend, parameters.Integer("friends"));
  add(Attitude::kStranger, parameters.Integer("strangers"));
  return arena;
}

Rules MakeRules(const sdk::Parameters& parameters) {
  return {.day = parameters.Text("task") == "day",
          .ram_speed = parameters.Real("ram_speed"),
          .tap_speed = parameters.Real("tap_speed"),
          .rams = static_cast<int>(parameters.Integer("rams")),
          .taps = static_cast<int>(parameters.Integer("taps")),
          .ride_seconds = parameters.Real("ride_time"),
          .spills = static_cast<int>(parameters.Integer("spills")),
          .thrills = static_cast<int>(parameters.Integer("thrills"))};
}

}  // namespace latchwork::bumper_cars
