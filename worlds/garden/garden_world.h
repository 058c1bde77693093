// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_GARDEN_GARDEN_WORLD_H_
#define LATCHWORK_GARDEN_GARDEN_WORLD_H_

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/world.h"
#include "worlds/garden/garden_sensors.h"
#include "worlds/garden/garden_state.h"

namespace latchwork::garden {

/// A season in a garden of pumpkins, as a world. The run is over at the end of the season: reached
/// when all plants live and weigh enough. Ports, events and parameters: garden_contract.h. Thread
/// rule: used by one thread.
class GardenWorld final : public sdk::World {
 public:
  GardenWorld();

  const sdk::Contract& contract() const override { return contract_; }
  std::span<const sdk::ParameterSpec> parameters() const override { return parameters_; }
  std::span<const sdk::PredicateSpec> events() const override { return events_; }

  logic::Diagnostics Load(const sdk::WorldSetup& setup, const sdk::Parameters& parameters) override;
  void Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) override;
  void Apply(std::uint64_t tick, std::span<const sdk::Batch> effectors) override;
  void Step(std::uint64_t tick) override;
  logic::Diagnostics HandleEvent(std::uint64_t tick, const logic::Fact& event) override;

  sdk::Outcome outcome() const override { return outcome_; }
  std::vector<std::pair<std::string, double>> Measures() const override;
  std::vector<std::filesystem::path> Draw(const std::filesystem::path& folder) const override;

  /// What the run changes; for tests. Only after a successful Load.
  const GardenState& state() const { return *state_; }

 private:
  void Judge();

  sdk::Contract contract_;
  std::vector<sdk::ParameterSpec> parameters_;
  std::vector<sdk::PredicateSpec> events_;
  std::optional<GardenState> state_;
  std::optional<GardenSensors> sensors_;
  std::optional<Task> task_;
  double tick_seconds_ = 300;
  double goal_weight_ = 0;
  int days_ = 0;
  sdk::Outcome outcome_;
};

}  // namespace latchwork::garden

#endif  // LATCHWORK_GARDEN_GARDEN_WORLD_H_
