// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/bumper_sensors.h"

#include <algorithm>
#include <utility>

#include "worlds/bumper_cars/bumper_contract.h"

namespace latchwork::bumper_cars {
namespace {

using logic::Fact;
using logic::Term;

constexpr double kFeelerAngle = 0.7;  // rad

}  // namespace

BumperSensors::BumperSensors(logic::SymbolTable& symbols, std::uint64_t seed, const Eyes& eyes,
                             const Arena& arena, std::string day)
    : symbols_(&symbols), random_(seed, "eyes"), eyes_(eyes), day_(std::move(day)) {
  for (const Car& car : arena.cars) names_.push_back(Word(car.name));
}

void BumperSensors::Say(Facts& facts, const char* predicate, std::initializer_list<Term> terms) {
  facts.emplace_back(symbols_->Intern(predicate), terms);
}

void BumperSensors::Observe(std::uint64_t tick, const Arena& arena, const Referee& referee,
                            std::span<sdk::Batch> sensors) {
  for (std::size_t port = 0; port < kSensorPorts; ++port) {
    const bool once = port == kTask || port == kPlaces || port == kPeople;
    sensors[port].updated = !once || tick == 0;
    if (port == kScore) sensors[port].updated = referee.version() != said_version_;
    if (sensors[port].updated) sensors[port].facts.clear();
  }
  if (tick == 0) {
    SayTask(referee, sensors[kTask].facts);
    SayPlaces(arena, sensors[kPlaces].facts);
    SayPeople(arena, sensors[kPeople].facts);
  }
  SaySelf(arena.cars[0], sensors[kSelf].facts);
  SayEyes(tick, arena, sensors[kEyes].facts);
  SayFeelers(arena, sensors[kFeelers].facts);
  SayTouch(arena, sensors[kTouchPort].facts);
  if (sensors[kScore].updated) SayScore(referee, arena, sensors[kScore].facts);
  said_version_ = referee.version();
}

void BumperSensors::SayTask(const Referee& referee, Facts& facts) {
  Say(facts, "task", {Word(referee.rules().day ? "day" : "collision")});
  Say(facts, "today", {Word(day_)});
  Say(facts, "spills_wanted", {Term::Integer(referee.rules().spills)});
  Say(facts, "thrills_wanted", {Term::Integer(referee.rules().thrills)});
}

void BumperSensors::SayPlaces(const Arena& arena, Facts& facts) {
  Say(facts, "arena", {Term::Real(arena.size.x), Term::Real(arena.size.y)});
  for (const Pole& pole : arena.poles) {
    Say(facts, "pole", {Word(pole.name), Term::Real(pole.place.x), Term::Real(pole.place.y)});
  }
  Say(facts, "gate", {Term::Real(arena.gate.x), Term::Real(arena.gate.y)});
}

void BumperSensors::SayPeople(const Arena& arena, Facts& facts) {
  for (std::size_t i = 1; i < arena.cars.size(); ++i) {
    const Car& car = arena.cars[i];
    const Term driver = Word(car.driver);
    Say(facts, "driver", {names_[i], driver});
    if (car.attitude == Attitude::kEnemy) Say(facts, "enemy", {driver});
    if (car.attitude == Attitude::kFriend) Say(facts, "friend", {driver});
  }
}

void BumperSensors::SaySelf(const Car& car, Facts& facts) {
  Say(facts, "pose", {Term::Real(car.place.x), Term::Real(car.place.y), Term::Real(car.heading)});
  Say(facts, "speed", {Term::Real(car.forward_speed())});
  Say(facts, "power", {Word(car.has_power() ? "on" : "off")});
}

void BumperSensors::SayEyes(std::uint64_t tick, const Arena& arena, Facts& facts) {
  const Car& own = arena.cars[0];
  for (std::size_t i = 1; i < arena.cars.size(); ++i) {
    const Vector to = arena.cars[i].place - own.place;
    const double distance = Length(to);
    const double bearing = WrapAngle(std::atan2(to.y, to.x) - own.heading);
    if (distance > eyes_.range || std::abs(bearing) > eyes_.field_of_view / 2) continue;
    const double far = distance * (1 + eyes_.noise * random_.Gaussian(tick, 2 * i));
    const double aside = WrapAngle(bearing + eyes_.noise * random_.Gaussian(tick, 2 * i + 1));
    Say(facts, "sees", {names_[i], Term::Real(std::max(0.0, far)), Term::Real(aside)});
  }
}

void BumperSensors::SayFeelers(const Arena& arena, Facts& facts) {
  const Car& own = arena.cars[0];
  Say(facts, "clear", {Word("ahead"), Term::Real(arena.ClearAhead(own, 0))});
  Say(facts, "clear", {Word("left"), Term::Real(arena.ClearAhead(own, kFeelerAngle))});
  Say(facts, "clear", {Word("right"), Term::Real(arena.ClearAhead(own, -kFeelerAngle))});
}

void BumperSensors::SayTouch(const Arena& arena, Facts& facts) {
  const Car& own = arena.cars[0];
  for (std::size_t i = 1; i < arena.cars.size(); ++i) {
    if (Arena::Touch(own, arena.cars[i])) Say(facts, "touching", {names_[i]});
  }
  for (const Pole& pole : arena.poles) {
    if (arena.Touches(own, pole)) Say(facts, "touching", {Word(pole.name)});
  }
  if (arena.TouchesWall(own)) Say(facts, "touching", {Word("wall")});
}

void BumperSensors::SayScore(const Referee& referee, const Arena& arena, Facts& facts) {
  for (std::size_t i = 1; i < arena.cars.size(); ++i) {
    if (referee.rammed(i)) Say(facts, "rammed", {names_[i]});
    if (referee.tapped(i)) Say(facts, "tapped", {names_[i]});
  }
  Say(facts, "spill_count", {Term::Integer(referee.spills())});
  Say(facts, "thrill_count", {Term::Integer(referee.thrills())});
  if (referee.park() != Referee::Park::kAtGate) Say(facts, "paid", {});
  const bool over =
      referee.park() == Referee::Park::kOver || referee.park() == Referee::Park::kOutside;
  if (over) Say(facts, "ride_over", {});
  if (referee.park() == Referee::Park::kOutside) Say(facts, "outside", {});
}

}  // namespace latchwork::bumper_cars
