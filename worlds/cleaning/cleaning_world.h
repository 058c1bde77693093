// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CLEANING_CLEANING_WORLD_H_
#define LATCHWORK_CLEANING_CLEANING_WORLD_H_

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/world.h"
#include "worlds/cleaning/cleaning_sensors.h"
#include "worlds/cleaning/cleaning_state.h"

namespace latchwork::cleaning {

/// A round robot with a brush and a battery on a floor of offices, as a world. The run is over when
/// enough of the floor in reach is clean and the robot stands on its dock again, or when its
/// battery is empty. Ports, events and parameters: cleaning_contract.h. Thread rule: used by one
/// thread.
class CleaningWorld final : public sdk::World {
 public:
  CleaningWorld();

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
  const CleaningState& state() const { return *state_; }

 private:
  void PutBoxes(std::uint64_t seed, std::int64_t count);
  void Remember(std::uint64_t tick);
  void Judge();

  sdk::Contract contract_;
  std::vector<sdk::ParameterSpec> parameters_;
  std::vector<sdk::PredicateSpec> events_;
  std::optional<CleaningState> state_;
  std::optional<CleaningSensors> sensors_;
  double tick_seconds_ = 0.1;
  double target_ = 1;
  double seconds_ = 0;
  bool touching_ = false;
  bool rests_ = true;
  int bumps_ = 0;
  int charges_ = 0;
  sdk::Outcome outcome_;
};

}  // namespace latchwork::cleaning

#endif  // LATCHWORK_CLEANING_CLEANING_WORLD_H_
