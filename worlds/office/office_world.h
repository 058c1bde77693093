// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_OFFICE_WORLD_H_
#define LATCHWORK_OFFICE_OFFICE_WORLD_H_

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/world.h"
#include "worlds/office/office_contract.h"
#include "worlds/office/office_effectors.h"
#include "worlds/office/office_sensors.h"
#include "worlds/office/office_state.h"

namespace latchwork::office {

/// A simulated office building with a round robot, as a world: several floors, sonar, elevators,
/// doors, people, boxes. Ports, events and parameters: office_contract.h. Thread rule: used by one
/// thread.
class OfficeWorld final : public sdk::World {
 public:
  OfficeWorld();

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
  const OfficeState& state() const { return *state_; }

 private:
  struct Counts {
    std::uint64_t ticks = 0;
    std::uint64_t collisions = 0;
    std::uint64_t rides = 0;
  };

  void StepElevators(std::uint64_t tick);
  void MoveRobot(std::uint64_t tick);
  void Collide(std::uint64_t tick, const Contact& contact);
  void Remember(std::uint64_t tick);
  void CheckGoal();
  void CheckTime();
  double Seconds() const { return static_cast<double>(counts_.ticks) * tick_seconds_; }

  sdk::Contract contract_;
  std::vector<sdk::ParameterSpec> parameters_;
  std::vector<sdk::PredicateSpec> events_;
  std::unique_ptr<OfficeState> state_;
  std::optional<OfficeSensors> sensors_;
  std::optional<OfficeEffectors> effectors_;
  double tick_seconds_ = 0.1;
  double drive_for_ = 0.0;
  bool end_at_collision_ = true;
  bool touching_ = false;
  Counts counts_;
  sdk::Outcome outcome_;
};

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_OFFICE_WORLD_H_
