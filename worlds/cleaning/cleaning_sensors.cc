// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cleaning/cleaning_sensors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "worlds/cleaning/cleaning_contract.h"

namespace latchwork::cleaning {

namespace {

using logic::Fact;
using logic::Term;

constexpr int kRangeFinders = 8;
constexpr double kLongestRange = 2.0;  // m
constexpr double kGlimpse = 1e-6;      // m beyond the edge of a tile

}  // namespace

CleaningSensors::CleaningSensors(const SensorOptions& options, std::uint64_t seed,
                                 logic::SymbolTable& symbols)
    : options_(options),
      pose_random_(seed, "pose"),
      view_random_(seed, "view"),
      range_random_(seed, "ranges"),
      tile_size_(symbols.Intern("tile_size")),
      dock_(symbols.Intern("dock")),
      pose_(symbols.Intern("pose")),
      picture_(symbols.Intern("picture")),
      row_in_view_(symbols.Intern("row_in_view")),
      tile_(symbols.Intern("tile")),
      dirty_(symbols.Intern("dirty")),
      clean_(symbols.Intern("clean")),
      blocked_(symbols.Intern("blocked")),
      range_(symbols.Intern("range")),
      bump_(symbols.Intern("bump")),
      ahead_(symbols.Intern("ahead")),
      left_(symbols.Intern("left")),
      right_(symbols.Intern("right")),
      behind_(symbols.Intern("behind")),
      battery_(symbols.Intern("battery")),
      charging_(symbols.Intern("charging")) {}

void CleaningSensors::Observe(std::uint64_t tick, const CleaningState& state,
                              std::span<sdk::Batch> sensors) {
  for (std::size_t port = 0; port < sensors.size(); ++port) {
    sensors[port].updated =
        (port != kRobot || tick == 0) && (port != kView || tick % options_.ticks_per_picture == 0);
    if (sensors[port].updated) sensors[port].facts.clear();
  }
  if (sensors[kRobot].updated) SayRobot(state, sensors[kRobot].facts);
  SayPose(tick, state, sensors[kPose].facts);
  if (sensors[kView].updated) SayView(tick, state, sensors[kView].facts);
  SayRanges(tick, state, sensors[kRanges].facts);
  SayTouch(state, sensors[kTouch].facts);
  SayPower(state, sensors[kPower].facts);
}

void CleaningSensors::SayRobot(const CleaningState& state, Facts& facts) const {
  facts.push_back(Fact(tile_size_, {Term::Real(kTile)}));
  const Tile home = state.plan.dock();
  facts.push_back(Fact(dock_, {Term::Integer(home.i), Term::Integer(home.j)}));
}

void CleaningSensors::SayPose(std::uint64_t tick, const CleaningState& state, Facts& facts) const {
  const Pose& pose = state.base.pose();
  const double x = pose.x + options_.pose_noise * pose_random_.Gaussian(tick, 0);
  const double y = pose.y + options_.pose_noise * pose_random_.Gaussian(tick, 1);
  const double heading =
      WrapAngle(pose.heading + options_.heading_noise * pose_random_.Gaussian(tick, 2));
  facts.push_back(Fact(pose_, {Term::Real(x), Term::Real(y), Term::Real(heading)}));
}

void CleaningSensors::SayView(std::uint64_t tick, const CleaningState& state, Facts& facts) {
  facts.push_back(Fact(picture_, {Term::Integer(++pictures_)}));
  const Tile middle = TileAt(state.base.place());
  const int reach = static_cast<int>(options_.sight / kTile) + 1;
  for (int j = middle.j - reach; j <= middle.j + reach; ++j) SayRow(tick, state, j, facts);
}

void CleaningSensors::SayRow(std::uint64_t tick, const CleaningState& state, int j,
                             Facts& facts) const {
  const std::size_t before = facts.size();
  const Tile middle = TileAt(state.base.place());
  const int reach = static_cast<int>(options_.sight / kTile) + 1;
  for (int i = middle.i - reach; i <= middle.i + reach; ++i) {
    if (!MakesOut(state, {i, j})) continue;
    facts.push_back(Fact(
        tile_, {Term::Integer(i), Term::Integer(j), Term::Constant(StateOf(tick, state, {i, j}))}));
  }
  if (facts.size() != before) facts.push_back(Fact(row_in_view_, {Term::Integer(j)}));
}

/// Whether the tile is near enough, and nothing stands before it.
bool CleaningSensors::MakesOut(const CleaningState& state, Tile tile) const {
  if (!state.plan.Contains(tile)) return false;
  const Point from = state.base.place();
  const Point to = CentreOf(tile);
  const double distance = std::hypot(to.x - from.x, to.y - from.y);
  if (distance > options_.sight) return false;
  const double direction = std::atan2(to.y - from.y, to.x - from.x);
  const double way = state.plan.FreeWay(from, direction, distance);
  if (way >= distance) return true;
  return TileAt({from.x + (way + kGlimpse) * std::cos(direction),
                 from.y + (way + kGlimpse) * std::sin(direction)}) == tile;
}

logic::Symbol CleaningSensors::StateOf(std::uint64_t tick, const CleaningState& state,
                                       Tile tile) const {
  if (!state.plan.IsFloor(tile)) return blocked_;
  const std::size_t index = state.plan.IndexOf(tile);
  const bool overlooked = view_random_.Uniform(tick, index) < options_.overlooked;
  return state.dirty[index] != 0 && !overlooked ? dirty_ : clean_;
}

void CleaningSensors::SayRanges(std::uint64_t tick, const CleaningState& state,
                                Facts& facts) const {
  for (int sensor = 0; sensor < kRangeFinders; ++sensor) {
    const double direction =
        state.base.pose().heading + 2.0 * std::numbers::pi * sensor / kRangeFinders;
    const double way =
        state.plan.FreeWay(state.base.place(), direction, kLongestRange + state.radius);
    const double noise =
        options_.range_noise * range_random_.Gaussian(tick, static_cast<std::uint64_t>(sensor));
    const double gap = std::clamp(way - state.radius + noise, 0.0, kLongestRange);
    facts.push_back(Fact(range_, {Term::Integer(sensor), Term::Real(gap)}));
  }
}

void CleaningSensors::SayTouch(const CleaningState& state, Facts& facts) const {
  if (!state.contact) return;
  const double quarters = *state.contact / (std::numbers::pi / 2);
  logic::Symbol side = quarters > 0 ? left_ : right_;
  if (std::abs(quarters) < 0.5) side = ahead_;
  if (std::abs(quarters) > 1.5) side = behind_;
  facts.push_back(Fact(bump_, {Term::Constant(side)}));
}

void CleaningSensors::SayPower(const CleaningState& state, Facts& facts) const {
  facts.push_back(Fact(battery_, {Term::Real(state.battery.charge())}));
  if (state.IsDocked()) facts.push_back(Fact(charging_, {}));
}

}  // namespace latchwork::cleaning
