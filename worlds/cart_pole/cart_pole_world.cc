// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cart_pole/cart_pole_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "worlds/cart_pole/cart_pole_contract.h"

namespace latchwork::cart_pole {

namespace {

using logic::Fact;
using logic::Term;
using State = sdk::Outcome::State;

constexpr double kLongestStep = 0.002;  // s
constexpr double kLongestTick = 0.1;    // s
constexpr double kHardestBlow = 10;     // N s

/// The draws of a tick.
enum Chance : std::uint64_t { kAngle, kRate, kPlace, kSpeed, kWhether, kHowHard };

Fact Make(logic::Symbol predicate, double value) { return {predicate, {Term::Real(value)}}; }

}  // namespace

CartPoleWorld::CartPoleWorld()
    : contract_(CartPoleContract()), parameters_(CartPoleParameters()), events_(CartPoleEvents()) {}

logic::Diagnostics CartPoleWorld::Load(const sdk::WorldSetup& setup,
                                       const sdk::Parameters& parameters) {
  if (setup.tick_seconds > kLongestTick) {
    return {{{}, "cart_pole needs a tick of at most 100ms", "set the agent's tick to 20ms", {}}};
  }
  logic::SymbolTable& table = *setup.symbols;
  symbols_ = {table.Intern("pole_angle"), table.Intern("pole_rate"), table.Intern("cart_place"),
              table.Intern("cart_speed"), table.Intern("track_end"), table.Intern("force_limit"),
              table.Intern("force")};
  tick_seconds_ = setup.tick_seconds;
  plant_ = {.cart_mass = parameters.Real("cart_mass"),
            .pole_mass = parameters.Real("pole_mass"),
            .pole_length = parameters.Real("pole_length"),
            .cart_friction = parameters.Real("cart_friction"),
            .pivot_friction = parameters.Real("pivot_friction")};
  limits_ = {parameters.Real("keep_for"), parameters.Real("fallen"), parameters.Real("track_end"),
             parameters.Real("force_limit")};
  noise_ = {parameters.Real("angle_noise"), parameters.Real("rate_noise"),
            parameters.Real("place_noise"), parameters.Real("speed_noise")};
  pushes_ = parameters.Real("pushes");
  push_strength_ = parameters.Real("push_strength");
  random_.emplace(setup.seed, "cart_pole");
  first_ = true;
  force_ = 0;
  tally_ = {};
  outcome_ = {};
  Start(parameters);
  picture_.Begin(limits_.track_end, plant_.pole_length, limits_.fallen);
  picture_.Remember(0, motion_);
  return {};
}

void CartPoleWorld::Start(const sdk::Parameters& parameters) {
  const sdk::RandomStream start(random_->Bits(0), "start");
  const auto within = [&](std::string_view name, std::uint64_t draw) {
    const double limit = parameters.Real(name);
    return limit * (2 * start.Uniform(0, draw) - 1);
  };
  motion_ = {.place = std::clamp(within("start_place", 2), -0.9 * limits_.track_end,
                                 0.9 * limits_.track_end),
             .speed = within("start_speed", 3),
             .angle = within("start_angle", 0),
             .rate = within("start_rate", 1)};
}

void CartPoleWorld::Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) {
  sdk::Batch& motion = sensors[kMotion];
  motion.updated = true;
  motion.facts.clear();
  const auto read = [&](double value, double noise, Chance draw) {
    return value + noise * random_->Gaussian(tick, draw);
  };
  motion.facts.push_back(Make(symbols_.pole_angle, read(motion_.angle, noise_.angle, kAngle)));
  motion.facts.push_back(Make(symbols_.pole_rate, read(motion_.rate, noise_.rate, kRate)));
  motion.facts.push_back(Make(symbols_.cart_place, read(motion_.place, noise_.place, kPlace)));
  motion.facts.push_back(Make(symbols_.cart_speed, read(motion_.speed, noise_.speed, kSpeed)));

  sdk::Batch& track = sensors[kTrack];
  track.updated = first_;
  if (!first_) return;
  track.facts = {Make(symbols_.track_end, limits_.track_end),
                 Make(symbols_.force_limit, limits_.force)};
  first_ = false;
}

void CartPoleWorld::Apply(std::uint64_t /*tick*/, std::span<const sdk::Batch> effectors) {
  force_ = 0;
  for (const Fact& fact : effectors[kMotor].facts) {
    if (fact.predicate() != symbols_.force || fact.arity() != 1) continue;
    if (!fact.argument(0).is_number() || !std::isfinite(fact.argument(0).number())) continue;
    force_ = std::clamp(fact.argument(0).number(), -limits_.force, limits_.force);
  }
}

void CartPoleWorld::Step(std::uint64_t tick) {
  if (outcome_.state != State::kRunning) return;
  PushAtRandom(tick);
  const double steps = std::ceil(tick_seconds_ / kLongestStep);
  for (int i = 0; i < static_cast<int>(steps); ++i) {
    motion_ = Advance(plant_, motion_, force_, tick_seconds_ / steps);
  }
  Count();
  Judge();
  picture_.Remember(tally_.seconds, motion_);
}

void CartPoleWorld::PushAtRandom(std::uint64_t tick) {
  if (random_->Uniform(tick, 2 * kWhether) >= pushes_ / 60 * tick_seconds_) return;
  Push(0, random_->Between(-push_strength_, push_strength_, tick, 2 * kHowHard));
}

void CartPoleWorld::Push(double cart, double tip) {
  motion_ = Strike(plant_, motion_, cart, tip);
  ++tally_.pushes;
  picture_.RememberPush(tally_.seconds);
}

void CartPoleWorld::Count() {
  ++tally_.ticks;
  tally_.seconds = static_cast<double>(tally_.ticks) * tick_seconds_;
  tally_.greatest_angle = std::max(tally_.greatest_angle, std::abs(motion_.angle));
  tally_.greatest_place = std::max(tally_.greatest_place, std::abs(motion_.place));
  tally_.place_squared += motion_.place * motion_.place;
  tally_.force_used += std::abs(force_) * tick_seconds_;
}

void CartPoleWorld::Judge() {
  if (std::abs(motion_.place) >= limits_.track_end) {
    outcome_ = {State::kFailed,
                fmt::format("the cart ran into the {} end of the track after {:.1f} s",
                            motion_.place > 0 ? "right" : "left", tally_.seconds)};
  } else if (std::abs(motion_.angle) >= limits_.fallen) {
    outcome_ = {State::kFailed, fmt::format("the pole fell to the {} after {:.1f} s",
                                            motion_.angle > 0 ? "right" : "left", tally_.seconds)};
  } else if (tally_.seconds >= limits_.keep_for - tick_seconds_ / 2) {
    outcome_ = {State::kReached, fmt::format("upright for {} s", limits_.keep_for)};
  }
}

logic::Diagnostics CartPoleWorld::HandleEvent(std::uint64_t /*tick*/, const Fact& event) {
  const auto name = event.predicate().name();
  const bool is_cart = name == "push_cart";
  if (event.arity() != 1 || !event.argument(0).is_number() || (!is_cart && name != "push_pole")) {
    return {{{}, "the cart and pole know no event '" + logic::ToString(event) + "'", {}, {}}};
  }
  const double blow = event.argument(0).number();
  if (!(std::abs(blow) <= kHardestBlow)) return {{{}, "a blow has at most 10 N s", {}, {}}};
  Push(is_cart ? blow : 0, is_cart ? 0 : blow);
  return {};
}

std::vector<std::pair<std::string, double>> CartPoleWorld::Measures() const {
  const double ticks = std::max(1.0, static_cast<double>(tally_.ticks));
  return {{"time_s", tally_.seconds},
          {"greatest_angle_rad", tally_.greatest_angle},
          {"greatest_place_m", tally_.greatest_place},
          {"rms_place_m", std::sqrt(tally_.place_squared / ticks)},
          {"mean_force_n", tally_.force_used / (ticks * tick_seconds_)},
          {"pushes", static_cast<double>(tally_.pushes)}};
}

std::vector<std::filesystem::path> CartPoleWorld::Draw(const std::filesystem::path& folder) const {
  return picture_.Draw(folder);
}

}  // namespace latchwork::cart_pole
