// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/bumper_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "worlds/bumper_cars/bumper_contract.h"
#include "worlds/bumper_cars/make_arena.h"

namespace latchwork::bumper_cars {
namespace {

using logic::Fact;
using logic::Term;

constexpr double kVisible = 0.3;  // m/s; slower bumps are not counted nor drawn

logic::Diagnostics Refuse(std::string why) { return {{{}, std::move(why), {}, {}}}; }

std::optional<double> Told(const std::vector<Fact>& facts, std::string_view predicate) {
  for (const Fact& fact : facts) {
    if (fact.predicate().name() != predicate || fact.arity() != 1) continue;
    if (fact.argument(0).is_number()) return fact.argument(0).number();
  }
  return std::nullopt;
}

bool Does(const std::vector<Fact>& facts, std::string_view predicate) {
  return std::any_of(facts.begin(), facts.end(),
                     [&](const Fact& fact) { return fact.predicate().name() == predicate; });
}

}  // namespace

BumperWorld::BumperWorld()
    : contract_(BumperContract()), parameters_(BumperParameters()), events_(BumperEvents()) {}

logic::Diagnostics BumperWorld::Load(const sdk::WorldSetup& setup,
                                     const sdk::Parameters& parameters) {
  const Rules rules = MakeRules(parameters);
  if (rules.rams > parameters.Integer("enemies")) {
    return {{parameters.PlaceOf("rams"), "more enemies are to be rammed than there are", {}, {}}};
  }
  if (rules.taps > parameters.Integer("friends")) {
    return {{parameters.PlaceOf("taps"), "more friends are to be tapped than there are", {}, {}}};
  }
  arena_ = MakeArena(parameters, setup.seed);
  referee_.emplace(rules, arena_.cars.size());
  const BumperSensors::Eyes eyes{parameters.Real("field_of_view") * std::numbers::pi / 180,
                                 parameters.Real("sight"), parameters.Real("sight_noise")};
  sensors_.emplace(*setup.symbols, setup.seed, eyes, arena_, parameters.Text("day"));
  rivals_.clear();
  for (std::size_t i = 1; i < arena_.cars.size(); ++i) rivals_.emplace_back(setup.seed, i);
  controls_.assign(arena_.cars.size(), {});
  tick_seconds_ = setup.tick_seconds;
  counts_ = {};
  film_ = {};
  film_.Add(0, arena_);
  return {};
}

void BumperWorld::Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) {
  sensors_->Observe(tick, arena_, *referee_, sensors);
}

void BumperWorld::Apply(std::uint64_t /*tick*/, std::span<const sdk::Batch> effectors) {
  controls_[0] = {Told(effectors[kDrive].facts, "pedal").value_or(0) / 100,
                  Told(effectors[kDrive].facts, "steer").value_or(0)};
  pays_ = Does(effectors[kGate].facts, "pay");
  leaves_ = Does(effectors[kGate].facts, "leave");
}

void BumperWorld::Remark(std::string text) {
  film_.remarks.push_back({Seconds(), arena_.cars[0].place, std::move(text)});
}

void BumperWorld::Step(std::uint64_t /*tick*/) {
  if (referee_->outcome().state != sdk::Outcome::State::kRunning) return;
  for (std::size_t i = 1; i < arena_.cars.size(); ++i) {
    controls_[i] = rivals_[i - 1].Decide(arena_, tick_seconds_);
  }
  if (!referee_->may_drive()) controls_[0] = {};
  const Vector before = arena_.cars[0].place;
  const std::vector<Bump> bumps = arena_.Step(controls_, tick_seconds_);
  ++counts_.ticks;
  counts_.distance += Length(arena_.cars[0].place - before);
  if (!arena_.cars[0].has_power()) counts_.without_power += tick_seconds_;
  for (const Bump& bump : bumps) {
    if (bump.impact.closing < kVisible) continue;
    if (bump.a == 0) ++counts_.bumps;
    film_.flashes.push_back({Seconds(), bump.impact.place, bump.impact.closing});
  }
  referee_->Step(bumps, arena_, tick_seconds_);
  if (pays_) referee_->Pay(tick_seconds_);
  if (leaves_) referee_->Leave(arena_, tick_seconds_);
  if (!referee_->remark().empty()) Remark(referee_->remark());
  film_.Add(Seconds(), arena_);
}

logic::Diagnostics BumperWorld::HandleEvent(std::uint64_t /*tick*/, const Fact& event) {
  const std::string_view name = event.predicate().name();
  if (name == "bell" && event.arity() == 0) {
    if (!referee_->RingBell()) return Refuse("nobody rides");
    Remark(referee_->remark());
    return {};
  }
  if (event.arity() != 1 || event.argument(0).kind() != Term::Kind::kConstant) {
    return Refuse("the arena knows no event '" + logic::ToString(event) + "'");
  }
  const std::string_view car_name = event.argument(0).symbol().name();
  const auto car = std::find_if(arena_.cars.begin(), arena_.cars.end(),
                                [&](const Car& c) { return c.name == car_name; });
  if (car == arena_.cars.end()) return Refuse(fmt::format("there is no car '{}'", car_name));
  if (name == "power_fails") {
    car->charge = 0;
  } else if (name == "stalls" || name == "drives_on") {
    car->stalled = name == "stalls";
  } else {
    return Refuse("the arena knows no event '" + logic::ToString(event) + "'");
  }
  Remark(logic::ToString(event));
  return {};
}

std::vector<std::pair<std::string, double>> BumperWorld::Measures() const {
  return {{"time_s", Seconds()},
          {"distance_m", counts_.distance},
          {"bumps", static_cast<double>(counts_.bumps)},
          {"enemies_rammed", static_cast<double>(referee_->CountRammed())},
          {"friends_tapped", static_cast<double>(referee_->CountTapped())},
          {"spills", static_cast<double>(referee_->spills())},
          {"thrills", static_cast<double>(referee_->thrills())},
          {"without_power_s", counts_.without_power}};
}

std::vector<std::filesystem::path> BumperWorld::Draw(const std::filesystem::path& folder) const {
  const auto file = folder / "bumper_cars.svg";
  if (!DrawFilm(film_, arena_, file)) return {};
  return {file};
}

}  // namespace latchwork::bumper_cars
