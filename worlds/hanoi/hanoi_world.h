// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_HANOI_HANOI_WORLD_H_
#define LATCHWORK_HANOI_HANOI_WORLD_H_

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/world.h"
#include "worlds/hanoi/gripper.h"
#include "worlds/hanoi/hand.h"
#include "worlds/hanoi/hanoi_contract.h"
#include "worlds/hanoi/hanoi_picture.h"
#include "worlds/hanoi/pegs.h"

namespace latchwork::hanoi {

/// The Tower of Hanoi with a gripper, and a hand that moves disks while the gripper works. The run
/// has reached its end when all disks are on the target; it has failed when a disk is put on a
/// smaller one. Thread rule: used by one thread.
class HanoiWorld final : public sdk::World {
 public:
  HanoiWorld();

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

  /// For tests; after a successful Load only.
  const Pegs& pegs() const { return *pegs_; }
  const Gripper& gripper() const { return *gripper_; }

 private:
  struct Words {
    explicit Words(logic::SymbolTable& symbols);
    logic::Symbol disks, peg, target, on_peg, topmost, above, raised, down, holds;
    logic::Symbol move_to, lower, raise, grasp, release;
    std::vector<logic::Term> pegs;
  };
  struct Counts {
    std::uint64_t ticks = 0;
    std::uint64_t moves = 0;
    std::uint64_t hand_moves = 0;
    std::uint64_t slips = 0;
    std::uint64_t refusals = 0;
  };

  void SayTask(std::vector<logic::Fact>& facts) const;
  void SayPosition(std::vector<logic::Fact>& facts) const;
  void SayGripper(std::vector<logic::Fact>& facts) const;
  Command Read(const logic::Fact& fact) const;
  void MoveByHand(const HandMove& move);
  void MoveGripper(std::uint64_t tick);
  double Seconds() const { return static_cast<double>(counts_.ticks) * tick_seconds_; }

  sdk::Contract contract_;
  std::vector<sdk::ParameterSpec> parameters_;
  std::vector<sdk::PredicateSpec> events_;
  std::optional<Words> words_;
  std::optional<Pegs> pegs_;
  std::optional<Gripper> gripper_;
  std::optional<Hand> hand_;
  std::optional<sdk::RandomStream> fingers_;
  double slip_ = 0;
  double tick_seconds_ = 0.1;
  int target_ = 0;
  int least_moves_ = 0;
  Command command_;
  bool refused_ = false;
  bool position_said_ = false;
  Counts counts_;
  Film film_;
  sdk::Outcome outcome_;
};

}  // namespace latchwork::hanoi

#endif  // LATCHWORK_HANOI_HANOI_WORLD_H_
