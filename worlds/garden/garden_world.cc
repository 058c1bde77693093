// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/garden_world.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "worlds/garden/garden_contract.h"
#include "worlds/garden/garden_picture.h"

namespace latchwork::garden {

namespace {

constexpr std::array<std::string_view, 6> kTasks = {"walk", "fill",  "pour",
                                                    "feed", "cover", "uncover"};

/// Nothing when it names no place of the garden.
std::optional<Task> TaskOf(const logic::Fact& fact, const GardenState& state) {
  for (std::size_t n = 0; n < kTasks.size(); ++n) {
    if (kTasks.at(n) != fact.predicate().name()) continue;
    Task task{static_cast<Task::Kind>(n), kWell};
    if (task.kind != Task::Kind::kWalk) return task;
    const auto place = state.PlaceOf(fact.argument(0).symbol().name());
    if (!place) return std::nullopt;
    task.place = *place;
    return task;
  }
  return std::nullopt;
}

}  // namespace

GardenWorld::GardenWorld()
    : contract_(GardenContract()), parameters_(GardenParameters()), events_(GardenEvents()) {}

logic::Diagnostics GardenWorld::Load(const sdk::WorldSetup& setup,
                                     const sdk::Parameters& parameters) {
  days_ = static_cast<int>(parameters.Integer("days"));
  GardenerOptions options;
  options.speed = parameters.Real("speed");
  options.tank = parameters.Real("tank");
  state_.emplace(setup.seed, days_, static_cast<int>(parameters.Integer("beds")),
                 static_cast<int>(parameters.Integer("plants")), options,
                 static_cast<int>(parameters.Integer("portions")));
  state_->barrel.holds = state_->barrel.water = parameters.Real("barrel");
  state_->barrel.spring = parameters.Real("spring");
  sensors_.emplace(parameters.Real("probe_noise"), setup.seed, *state_, *setup.symbols);
  task_.reset();
  tick_seconds_ = setup.tick_seconds;
  goal_weight_ = parameters.Real("goal_weight");
  outcome_ = {};
  return {};
}

void GardenWorld::Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) {
  sensors_->Observe(tick, *state_, sensors);
}

void GardenWorld::Apply(std::uint64_t /*tick*/, std::span<const sdk::Batch> effectors) {
  const std::vector<logic::Fact>& work = effectors[kWork].facts;
  task_ = work.empty() ? std::nullopt : TaskOf(work[0], *state_);
}

void GardenWorld::Step(std::uint64_t /*tick*/) {
  if (outcome_.state != sdk::Outcome::State::kRunning) return;
  state_->Step(task_, tick_seconds_);
  if (state_->hour >= 24.0 * days_) {
    Judge();
  } else if (state_->Alive() == 0) {
    outcome_ = {sdk::Outcome::State::kFailed,
                fmt::format("all pumpkins are dead on day {} of {}", state_->day() + 1, days_)};
  }
}

void GardenWorld::Judge() {
  const int alive = state_->Alive();
  const double weight = state_->Weight();
  const bool reached = alive == state_->Plants() && weight >= goal_weight_;
  outcome_ = {
      reached ? sdk::Outcome::State::kReached : sdk::Outcome::State::kFailed,
      fmt::format("{} of {} pumpkins live and weigh {:.0f} kg", alive, state_->Plants(), weight)};
}

logic::Diagnostics GardenWorld::HandleEvent(std::uint64_t /*tick*/, const logic::Fact& event) {
  const std::string_view name = event.predicate().name();
  if (name == "spring_gives") {
    if (event.argument(0).number() < 0) return {{{}, "a spring takes no water away", {}, {}}};
    state_->barrel.spring = event.argument(0).number();
  } else if (name == "food_delivered") {
    const std::int64_t portions = event.argument(0).integer();
    if (portions < 0 || portions > 10000) return {{{}, "0 to 10000 portions come at once", {}, {}}};
    state_->gardener.AddPortions(static_cast<int>(portions));
  } else {
    const auto place = state_->PlaceOf(event.argument(0).symbol().name());
    if (!place || *place == kWell) return {{{}, "the garden has no such bed", {}, {}}};
    state_->beds[*place].Harm(event.argument(1).number());
  }
  return {};
}

std::vector<std::pair<std::string, double>> GardenWorld::Measures() const {
  return {{"weight_kg", state_->Weight()},
          {"alive", state_->Alive()},
          {"plants", state_->Plants()},
          {"least_health", state_->LeastHealth()},
          {"poured_l", state_->gardener.poured()},
          {"portions_left", state_->gardener.portions()},
          {"walked_m", state_->gardener.walked()}};
}

std::vector<std::filesystem::path> GardenWorld::Draw(const std::filesystem::path& folder) const {
  return DrawGarden(*state_, folder);
}

}  // namespace latchwork::garden
