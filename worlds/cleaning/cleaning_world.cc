// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cleaning/cleaning_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "latchwork/sdk/random.h"
#include "worlds/cleaning/cleaning_contract.h"
#include "worlds/cleaning/cleaning_picture.h"
#include "worlds/cleaning/reach.h"

namespace latchwork::cleaning {

namespace {

constexpr std::uint64_t kRouteEvery = 3;  // ticks
constexpr std::size_t kMostRoute = 100000;
constexpr std::uint64_t kTriesPerBox = 200;
constexpr std::size_t kMostLost = 60;  // tiles that a box may take out of reach
/// A way of three tiles is wide enough for it, one that is two wide and two deep is not: past a box
/// the way is never a matter of centimetres.
constexpr double kWideDisc = 0.37;  // m

std::size_t ReachOfWideDisc(const CleaningState& state) {
  const std::vector<char> reached = TilesInReach(state.plan, kWideDisc, state.brush);
  return static_cast<std::size_t>(std::count(reached.begin(), reached.end(), char{1}));
}

FloorPlan LoadPlan(const sdk::WorldSetup& setup, const sdk::Parameters& parameters,
                   logic::Diagnostics& diagnostics) {
  const std::filesystem::path given = parameters.File("plan");
  const std::filesystem::path file = given.empty() ? setup.data / "data/office.txt" : given;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    diagnostics.push_back(
        {parameters.PlaceOf("plan"), "cannot read the plan '" + file.string() + "'", {}, {}});
    return {};
  }
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return ReadFloorPlan(text, file.string(), diagnostics);
}

SensorOptions SensorsOf(const sdk::WorldSetup& setup, const sdk::Parameters& parameters) {
  const double ticks = parameters.Real("picture_period") / setup.tick_seconds;
  return {parameters.Real("sight"),
          static_cast<std::uint64_t>(std::max(1.0, std::round(ticks))),
          parameters.Real("overlooked"),
          parameters.Real("pose_noise"),
          parameters.Real("heading_noise"),
          parameters.Real("range_noise")};
}

}  // namespace

CleaningWorld::CleaningWorld()
    : contract_(CleaningContract()), parameters_(CleaningParameters()), events_(CleaningEvents()) {}

logic::Diagnostics CleaningWorld::Load(const sdk::WorldSetup& setup,
                                       const sdk::Parameters& parameters) {
  logic::Diagnostics diagnostics;
  FloorPlan plan = LoadPlan(setup, parameters, diagnostics);
  const double radius = parameters.Real("radius");
  if (diagnostics.empty() && plan.Touches(CentreOf(plan.dock()), radius)) {
    diagnostics.push_back(
        {parameters.PlaceOf("plan"), "the dock has no room for the robot", {}, {}});
  }
  if (!diagnostics.empty()) return diagnostics;
  BaseLimits limits;
  limits.radius = radius;
  limits.max_speed = parameters.Real("max_speed");
  const BatteryOptions battery{parameters.Real("capacity"), parameters.Real("idle_power"),
                               parameters.Real("brush_power"), parameters.Real("drive_power"),
                               parameters.Real("dock_power")};
  state_.emplace(std::move(plan), limits, battery);
  const sdk::RandomStream random(setup.seed, "start");
  state_->Begin(random.Between(-std::numbers::pi, std::numbers::pi, 0), radius,
                parameters.Real("brush"));
  PutBoxes(setup.seed, parameters.Integer("boxes"));
  sensors_.emplace(SensorsOf(setup, parameters), setup.seed, *setup.symbols);
  tick_seconds_ = setup.tick_seconds;
  target_ = parameters.Real("target");
  seconds_ = 0;
  touching_ = false;
  rests_ = true;
  bumps_ = charges_ = 0;
  outcome_ = {};
  return {};
}

/// Boxes stand where they do not close off a part of the floor, nor leave but a narrow way to it.
void CleaningWorld::PutBoxes(std::uint64_t seed, std::int64_t count) {
  const sdk::RandomStream random(seed, "boxes");
  for (std::int64_t box = 0; box < count; ++box) {
    for (std::uint64_t attempt = 0; attempt < kTriesPerBox; ++attempt) {
      const auto index =
          random.Index(state_->plan.size(), static_cast<std::uint64_t>(box), attempt);
      const Tile corner = state_->plan.TileOf(static_cast<std::size_t>(index));
      if (!state_->HasRoomForBox(corner)) continue;
      CleaningState with_box = *state_;
      with_box.PutBox(corner);
      if (with_box.tiles_in_reach + kMostLost < state_->tiles_in_reach) continue;
      if (ReachOfWideDisc(with_box) + kMostLost < ReachOfWideDisc(*state_)) continue;
      state_ = std::move(with_box);
      break;
    }
  }
}

void CleaningWorld::Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) {
  sensors_->Observe(tick, *state_, sensors);
}

void CleaningWorld::Apply(std::uint64_t /*tick*/, std::span<const sdk::Batch> effectors) {
  const std::vector<logic::Fact>& drive = effectors[kDrive].facts;
  if (drive.empty()) {
    state_->base.Drive(0, 0);
  } else {
    state_->base.Drive(drive[0].argument(0).number(), drive[0].argument(1).number());
  }
}

void CleaningWorld::Step(std::uint64_t tick) {
  if (outcome_.state != sdk::Outcome::State::kRunning) return;
  seconds_ = static_cast<double>(tick + 1) * tick_seconds_;
  state_->contact = state_->base.Step(tick_seconds_, state_->plan);
  if (state_->contact && !touching_) ++bumps_;
  touching_ = state_->contact.has_value();
  const bool docked = state_->IsDocked();
  const bool rests = docked && state_->base.speed() == 0.0;
  if (rests && !rests_) ++charges_;
  rests_ = rests;
  state_->battery.Step(tick_seconds_, state_->base.speed(), docked);
  if (!docked) state_->Sweep(seconds_);
  Judge();
  Remember(tick);
}

void CleaningWorld::Judge() {
  const Pose& pose = state_->base.pose();
  if (state_->battery.is_empty()) {
    outcome_ = {sdk::Outcome::State::kFailed,
                fmt::format("the battery is empty at {:.2f}, {:.2f}", pose.x, pose.y)};
  } else if (rests_ && charges_ > 0 && state_->CleanPart() >= target_) {
    outcome_ = {sdk::Outcome::State::kReached,
                fmt::format("{:.1f} % of the floor is clean", 100 * state_->CleanPart())};
  }
}

void CleaningWorld::Remember(std::uint64_t tick) {
  const bool over = outcome_.state != sdk::Outcome::State::kRunning;
  if ((tick % kRouteEvery != 0 && !over) || state_->route.size() >= kMostRoute) return;
  state_->route.push_back({seconds_, state_->base.pose(), state_->battery.charge()});
}

logic::Diagnostics CleaningWorld::HandleEvent(std::uint64_t /*tick*/, const logic::Fact& event) {
  const Point place{event.argument(0).number(), event.argument(1).number()};
  if (event.arity() == 3) {
    state_->Spill(place, event.argument(2).number());
    return {};
  }
  const Tile corner = TileAt({place.x - kTile / 2, place.y - kTile / 2});
  if (!state_->HasRoomForBox(corner)) {
    return {{{}, "there is no room for the box at this place", {}, {}}};
  }
  state_->PutBox(corner);
  return {};
}

std::vector<std::pair<std::string, double>> CleaningWorld::Measures() const {
  return {{"clean_part", state_->CleanPart()},
          {"floor_m2", static_cast<double>(state_->tiles_in_reach) * kTile * kTile},
          {"time_s", seconds_},
          {"distance_m", state_->base.travelled()},
          {"charges", charges_},
          {"lowest_charge", state_->battery.lowest_charge()},
          {"bumps", bumps_}};
}

std::vector<std::filesystem::path> CleaningWorld::Draw(const std::filesystem::path& folder) const {
  return DrawCleaning(*state_, folder);
}

}  // namespace latchwork::cleaning
