// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/people.h"

#include <algorithm>
#include <cmath>

#include "worlds/office/collision.h"

namespace latchwork::office {

namespace {

constexpr double kRightHand = 0.4;  // from the middle of the corridor, m

bool IsInCorridor(const Building& building, std::size_t index) {
  const Landmark& landmark = building.landmarks[index];
  if (landmark.floor < 0 || building.FindDoor(landmark.name.name())) return false;
  const bool in_room =
      std::any_of(building.rooms.begin(), building.rooms.end(), [&](const Room& room) {
        return room.floor == landmark.floor && room.area.Contains(landmark.place);
      });
  const bool at_elevator = std::any_of(
      building.elevators.begin(), building.elevators.end(), [&](const ElevatorShaft& shaft) {
        return std::find(shaft.lobbies.begin(), shaft.lobbies.end(), index) != shaft.lobbies.end();
      });
  return !in_room && !at_elevator;
}

}  // namespace

std::vector<std::vector<std::size_t>> CorridorWays(const Building& building) {
  std::vector<char> corridor;
  for (std::size_t i = 0; i < building.landmarks.size(); ++i) {
    corridor.push_back(IsInCorridor(building, i) ? 1 : 0);
  }
  std::vector<std::vector<std::size_t>> ways(building.landmarks.size());
  for (const Edge& edge : building.edges) {
    if (corridor[edge.a] == 0 || corridor[edge.b] == 0) continue;
    ways[edge.a].push_back(edge.b);
    ways[edge.b].push_back(edge.a);
  }
  return ways;
}

People::People(const PeopleOptions& options, const Building& building, double tick_seconds,
               std::uint64_t seed, int robot_floor, Point keep_free)
    : options_(options),
      building_(&building),
      dt_(tick_seconds),
      random_(seed, "people"),
      ways_(CorridorWays(building)),
      discs_(building.floors.size()) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    const Landmark& landmark = building.landmarks[i];
    const bool near = landmark.floor == robot_floor && Distance(landmark.place, keep_free) < 3.0;
    if (!ways_[i].empty() && !near) starts.push_back(i);
  }
  const std::size_t count = std::min(static_cast<std::size_t>(options.count), starts.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t pick = random_.Index(starts.size(), i, 0);
    Person person;
    person.from = starts[pick];
    starts.erase(starts.begin() + static_cast<std::ptrdiff_t>(pick));
    const auto& ways = ways_[person.from];
    person.to = ways[random_.Index(ways.size(), i, 1)];
    person.floor = building.landmarks[person.from].floor;
    person.place = building.landmarks[person.from].place;
    person.speed = options.speed * random_.Between(0.85, 1.15, i, 2);
    people_.push_back(person);
  }
  CollectDiscs();
}

Point People::AimOf(const Person& person) const {
  const Point a = building_->landmarks[person.from].place;
  const Point b = building_->landmarks[person.to].place;
  const double length = std::max(1e-9, Distance(a, b));
  const double beside = person.side * kRightHand / length;
  return {b.x + beside * (b.y - a.y), b.y - beside * (b.x - a.x)};
}

bool People::IsInTheWay(const Person& person, Point next, const Disc& other) const {
  const double now = Distance(person.place, other.centre);
  const double then = Distance(next, other.centre);
  if (then >= now) return false;
  const double reach = options_.radius + other.radius;
  if (then < reach + 0.1) return true;
  if (now > reach + options_.distance) return false;
  const double ahead = ((other.centre.x - person.place.x) * (next.x - person.place.x) +
                        (other.centre.y - person.place.y) * (next.y - person.place.y));
  const double step = std::max(1e-9, Distance(person.place, next));
  const double beside = std::sqrt(std::max(0.0, now * now - ahead * ahead / (step * step)));
  return beside < reach + 0.15;
}

bool People::ComesTooNear(const Person& person, Point next, const Disc& robot) const {
  const double then = Distance(next, robot.centre);
  const double closest = options_.radius + robot.radius + options_.distance;
  return then < closest && then < Distance(person.place, robot.centre);
}

bool People::IsBlocked(std::size_t self, Point next, const FloorMap& map, int robot_floor,
                       const Disc& robot) const {
  const Person& person = people_[self];
  if (person.floor == robot_floor && ComesTooNear(person, next, robot)) return true;
  for (std::size_t i = 0; i < people_.size(); ++i) {
    if (i == self || people_[i].floor != person.floor) continue;
    if (IsInTheWay(person, next, {people_[i].place, options_.radius})) return true;
  }
  return FindContact(map, next, options_.radius).has_value();
}

std::size_t People::NextLandmark(const Person& person, std::uint64_t tick, std::size_t self) const {
  const auto& ways = ways_[person.to];
  const std::size_t pick = random_.Index(ways.size(), tick, 10 + self);
  // Nobody turns on the spot unless the corridor ends.
  if (ways[pick] == person.from && ways.size() > 1) return ways[(pick + 1) % ways.size()];
  return ways[pick];
}

void People::Step(std::uint64_t tick, std::span<const FloorMap> maps, int robot_floor,
                  const Disc& robot) {
  for (std::size_t i = 0; i < people_.size(); ++i) {
    Person& person = people_[i];
    const Point aim = AimOf(person);
    const double rest = Distance(person.place, aim);
    const double step = std::min(rest, person.speed * dt_);
    if (rest < 1e-6) {
      const std::size_t next = NextLandmark(person, tick, i);
      person.from = person.to;
      person.to = next;
      person.side = 1.0;
      continue;
    }
    const Point next{person.place.x + (aim.x - person.place.x) * step / rest,
                     person.place.y + (aim.y - person.place.y) * step / rest};
    if (!IsBlocked(i, next, maps[static_cast<std::size_t>(person.floor)], robot_floor, robot)) {
      person.place = next;
      person.waited = 0;
      person.turned = false;
    } else if (++person.waited * dt_ > options_.patience) {
      Turn(person);
    }
  }
  CollectDiscs();
}

/// Round to the other side of the corridor; if that was no use either, to its other side, and so
/// on.
void People::Turn(Person& person) {
  if (person.turned) {
    person.side = -person.side;
  } else {
    std::swap(person.from, person.to);
  }
  person.turned = !person.turned;
  person.waited = 0;
}

void People::CollectDiscs() {
  for (auto& discs : discs_) discs.clear();
  for (const Person& person : people_) {
    discs_[static_cast<std::size_t>(person.floor)].push_back({person.place, options_.radius});
  }
}

}  // namespace latchwork::office
