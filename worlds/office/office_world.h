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
#include "worlds/office/destinations.h"
#include "worlds/office/office_contract.h"
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
  void InternWords(logic::SymbolTable& symbols);
  void ObserveSonar(std::uint64_t tick, std::vector<logic::Fact>& facts);
  void ObservePlace(std::vector<logic::Fact>& facts) const;
  void ObserveElevators(std::vector<logic::Fact>& facts) const;
  void ObserveDoors(std::vector<logic::Fact>& facts);
  void ObserveRobot(std::vector<logic::Fact>& facts) const;
  void ObserveBuilding(std::vector<logic::Fact>& facts) const;
  void ObserveDestination(std::uint64_t tick, std::vector<logic::Fact>& facts);
  void Drive(const sdk::Batch& batch);
  void PressButtons(const sdk::Batch& batch);
  void StepElevators(std::uint64_t tick);
  void MoveRobot(std::uint64_t tick);
  void Remember(std::uint64_t tick);
  void CheckGoal();
  void Remark(std::uint64_t tick, std::string text);
  std::string EventError(const logic::Fact& event, std::uint64_t tick);
  std::string SetDoorByEvent(const logic::Fact& event, bool shut);
  std::string SetServiceByEvent(const logic::Fact& event, bool in_service);
  std::string PutBox(const logic::Fact& event);

  sdk::Contract contract_;
  std::vector<sdk::ParameterSpec> parameters_;
  std::vector<sdk::PredicateSpec> events_;
  std::unique_ptr<OfficeState> state_;
  double tick_seconds_ = 0.1;
  bool end_at_collision_ = true;
  std::optional<Destinations> destinations_;
  sdk::Outcome outcome_;
  std::uint64_t collisions_ = 0;
  std::uint64_t rides_ = 0;
  bool touching_ = false;
  std::optional<double> last_turn_;

  logic::Symbol sonar_reading_, no_echo_, curr_location_, curr_heading_, curr_landmark_,
      curr_floor_, elevator_at_, elevator_door_, elevator_moving_, elevator_open_,
      elevator_out_of_order_, inside_, out_of_order_, door_shut_, goal_, fwd_, turn_, halt_, call_,
      ride_, move_cmd_;
  logic::SymbolTable* symbols_ = nullptr;
  std::vector<logic::Symbol> door_states_;  ///< By Elevator::Door.
};

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_OFFICE_WORLD_H_
