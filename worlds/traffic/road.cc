// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/road.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace latchwork::traffic {

namespace {

constexpr double kTruckLength = 12.0;  // m
constexpr double kTruckSpeed = 0.75;   // of the limit
constexpr double kKeepRight = 0.1;     // m/s^2
constexpr double kDecideEvery = 0.5;   // s
constexpr double kRestAfter = 4.0;     // s between changes of lane

}  // namespace

Road::Road(const RoadSetup& setup, logic::SymbolTable& symbols)
    : setup_(setup), random_(setup.seed, "drivers") {
  for (int lane = 0; lane < setup_.lanes; ++lane) AddCars(lane, symbols);
  const auto agent = random_.Index(cars_.size(), 0, 99);
  std::swap(cars_[kAgent], cars_[agent]);
  Car& car = cars_[kAgent];
  car.length = Car().length;
  car.driver = Driver();
  car.driver.wanted_speed = setup_.speed_limit;
  commands_.resize(cars_.size());
}

void Road::AddCars(int lane, logic::SymbolTable& symbols) {
  const auto count = std::max<std::int64_t>(1, std::llround(setup_.density * setup_.length / 1000));
  const double room = setup_.length / static_cast<double>(count);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::uint64_t number = cars_.size();
    Car car;
    const double share = lane + 1 == setup_.lanes && setup_.lanes > 1 ? 0.0 : setup_.trucks;
    const bool truck = random_.Uniform(number, 0) < share;
    car.name = symbols.Intern((truck ? "truck" : "car") + std::to_string(number));
    if (truck) car.length = kTruckLength;
    const double spread = std::max(0.0, room - kTruckLength - 8.0) / 2;
    car.s = room * static_cast<double>(i) + random_.Between(-spread, spread, number, 1);
    car.s = Forward(0, car.s);
    car.y = lane * kLaneWidth;
    car.aim = lane;
    car.driver = SomeDriver(number, truck);
    car.speed = std::min(car.driver.wanted_speed, 0.7 * setup_.speed_limit);
    cars_.push_back(car);
  }
}

Driver Road::SomeDriver(std::uint64_t number, bool truck) const {
  const double share = truck ? kTruckSpeed : 0.9;
  Driver driver;
  driver.wanted_speed =
      setup_.speed_limit * (share + (truck ? 0.03 : 0.13) * random_.Gaussian(number, 1));
  driver.wanted_speed =
      std::clamp(driver.wanted_speed, 0.6 * setup_.speed_limit, 1.15 * setup_.speed_limit);
  driver.headway = random_.Between(1.0, 1.7, number, 4);
  driver.acceleration = truck ? 0.8 : random_.Between(1.1, 1.8, number, 5);
  driver.politeness = random_.Between(0.1, 0.5, number, 6);
  return driver;
}

double Road::Forward(double from, double to) const {
  double way = to - from;
  if (std::abs(way) >= setup_.length) way = std::fmod(way, setup_.length);
  return way < 0 ? way + setup_.length : way;
}

std::optional<Road::Neighbour> Road::Ahead(std::size_t car, int lane) const {
  std::optional<Neighbour> nearest;
  for (std::size_t i = 0; i < cars_.size(); ++i) {
    if (i == car || !cars_[i].Occupies(lane)) continue;
    const double way = Forward(cars_[car].s, cars_[i].s);
    if (way > setup_.length / 2) continue;
    const double gap = way - (cars_[car].length + cars_[i].length) / 2;
    if (!nearest || gap < nearest->gap) nearest = {i, gap};
  }
  return nearest;
}

std::optional<Road::Neighbour> Road::Behind(std::size_t car, int lane) const {
  std::optional<Neighbour> nearest;
  for (std::size_t i = 0; i < cars_.size(); ++i) {
    if (i == car || !cars_[i].Occupies(lane)) continue;
    const double way = Forward(cars_[i].s, cars_[car].s);
    if (way > setup_.length / 2) continue;
    const double gap = way - (cars_[car].length + cars_[i].length) / 2;
    if (!nearest || gap < nearest->gap) nearest = {i, gap};
  }
  return nearest;
}

double Road::FollowIn(std::size_t car, int lane) const {
  std::optional<Leader> leader;
  if (const auto ahead = Ahead(car, lane)) leader = {ahead->gap, cars_[ahead->car].speed};
  return FollowingAcceleration(cars_[car].driver, cars_[car].speed, leader);
}

double Road::Follow(std::size_t car) const {
  double least = FollowIn(car, cars_[car].aim);
  for (int lane = 0; lane < setup_.lanes; ++lane) {
    if (lane != cars_[car].aim && cars_[car].Occupies(lane)) {
      least = std::min(least, FollowIn(car, lane));
    }
  }
  return least;
}

std::optional<double> Road::GainIn(std::size_t car, int lane) const {
  const Car& me = cars_[car];
  const auto ahead = Ahead(car, lane);
  const auto behind = Behind(car, lane);
  const double closest = me.driver.standstill_gap;
  if ((ahead && ahead->gap < closest) || (behind && behind->gap < closest)) return std::nullopt;
  LaneChange change;
  change.mine_now = FollowIn(car, me.aim);
  change.mine_then = FollowIn(car, lane);
  change.bias = lane < me.aim ? kKeepRight : -kKeepRight;
  if (behind) {
    const Car& other = cars_[behind->car];
    change.follower_now = FollowIn(behind->car, lane);
    change.follower_then =
        FollowingAcceleration(other.driver, other.speed, Leader{behind->gap, me.speed});
  }
  if (change.mine_then < -me.driver.braking) return std::nullopt;
  return Gain(change, me.driver.politeness);
}

void Road::ConsiderLanes(std::size_t car, std::uint64_t tick) {
  Car& me = cars_[car];
  const auto every =
      static_cast<std::uint64_t>(std::max(1L, std::lround(kDecideEvery / setup_.dt)));
  if (tick % every != car % every || tick < me.may_change_at || !me.settled()) return;
  std::optional<int> best;
  double most = 0;
  for (const int lane : {me.aim + 1, me.aim - 1}) {
    const bool truck_in_left_lane = me.length > 10 && lane + 1 == setup_.lanes && setup_.lanes > 1;
    if (lane < 0 || lane >= setup_.lanes || truck_in_left_lane) continue;
    const auto gain = GainIn(car, lane);
    if (!gain || *gain <= most) continue;
    most = *gain;
    best = lane;
  }
  if (!best) return;
  me.aim = *best;
  const double rest = kRestAfter * random_.Between(1.0, 2.0, tick, 100 + car);
  me.may_change_at = tick + static_cast<std::uint64_t>(rest / setup_.dt);
}

void Road::Step(std::uint64_t tick, std::optional<double> command) {
  for (std::size_t i = 0; i < cars_.size(); ++i) {
    if (i != kAgent || !command) ConsiderLanes(i, tick);
  }
  for (std::size_t i = 0; i < cars_.size(); ++i) {
    commands_[i] = tick < cars_[i].brakes_until ? -5.0 : Follow(i);
  }
  if (command) commands_[kAgent] = *command;
  for (std::size_t i = 0; i < cars_.size(); ++i) {
    Move(cars_[i], commands_[i], setup_.dt);
    cars_[i].s = Forward(0, cars_[i].s);
  }
}

void Road::PlaceAgent() {
  double widest = -1;
  Car& me = cars_[kAgent];
  Car placed = me;
  for (std::size_t i = 1; i < cars_.size(); ++i) {
    const Car& behind = cars_[i];
    me.s = behind.s;
    me.y = -100.0;  // beside the road
    me.aim = -10;
    const auto ahead = Ahead(i, behind.aim);
    const double gap = ahead ? ahead->gap : setup_.length / 2;
    if (!behind.settled() || gap <= widest) continue;
    widest = gap;
    placed.s = Forward(0, behind.s + (behind.length + gap) / 2);
    placed.aim = behind.aim;
    placed.speed = behind.speed;
  }
  placed.y = placed.aim * kLaneWidth;
  placed.acceleration = 0;
  placed.side_speed = 0;
  me = placed;
}

bool Road::Touch(const Car& a, const Car& b) const {
  if (std::abs(a.y - b.y) >= (a.width + b.width) / 2) return false;
  return std::min(Forward(a.s, b.s), Forward(b.s, a.s)) < (a.length + b.length) / 2;
}

std::optional<std::size_t> Road::Touched() const {
  for (std::size_t i = 1; i < cars_.size(); ++i) {
    if (Touch(cars_[kAgent], cars_[i])) return i;
  }
  return std::nullopt;
}

std::size_t Road::TouchingOthers() const {
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < cars_.size(); ++i) {
    for (std::size_t j = i + 1; j < cars_.size(); ++j) {
      if (Touch(cars_[i], cars_[j])) ++pairs;
    }
  }
  return pairs;
}

}  // namespace latchwork::traffic
