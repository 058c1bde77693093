// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_ARBITRATION_H_
#define LATCHWORK_SCHEDULE_ARBITRATION_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/schedule/port_contract.h"
#include "latchwork/schedule/agent.h"
#include "latchwork/schedule/tick_record.h"
#include "latchwork/sdk/world.h"

namespace latchwork::schedule {

/// Holds what the layers say until it is due to leave, applies inhibition, and addresses the rest
/// to latches and effectors. Thread rule: used by one thread.
class Arbitration {
 public:
  /// Receives a batch addressed to the latch of a layer.
  using Deliver = std::function<void(const config::PortAddress& to, const sdk::Batch& batch,
                                     std::uint64_t arrival)>;

  explicit Arbitration(const Agent& agent);

  /// What a layer said in its cycle at `tick`, one batch per output port.
  void Accept(std::size_t layer, std::uint64_t tick, std::span<const sdk::Batch> said);
  /// What a sensor said at `tick`, for inhibitions.
  void NoteSensor(std::size_t port, std::uint64_t tick, bool has_facts);
  /// Lets leave what is due at `tick`; adds to the record's inhibited and refused.
  void Release(std::uint64_t tick, const Deliver& deliver, TickRecord& record);
  /// What the effectors are told now.
  std::span<const sdk::Batch> commands() const { return commands_; }

 private:
  struct Spoken {
    std::uint64_t tick = 0;
    bool has_facts = false;
  };
  struct Waiting {
    std::uint64_t leave = 0;
    std::vector<sdk::Batch> said;
  };
  struct LayerState {
    std::uint64_t latency = 0;
    std::deque<Waiting> waiting;
    std::vector<Waiting> spare;
    Waiting leaving;  ///< Of this tick, when `leaves`.
    bool leaves = false;
    std::vector<Spoken> spoken;   ///< By output port.
    std::vector<bool> inhibited;  ///< By output port, in this tick.
  };
  struct EffectorState {
    PortContract contract;
    config::PortAddress source;
    std::uint64_t hold = 1;
    std::optional<std::uint64_t> told;  ///< The tick in which it was told something.
  };

  void AddEffectors(const Agent& agent);
  void AddInhibitions(const Agent& agent);
  void TakeDue(std::uint64_t tick);
  void Inhibit(std::uint64_t tick, TickRecord& record);
  void Address(std::uint64_t tick, const Deliver& deliver, TickRecord& record);
  /// As much of a batch as the wire hands down.
  const sdk::Batch& HandDown(const sdk::Batch& batch, config::Transfer transfer);
  void Tell(const config::PortAddress& to, std::uint64_t tick,
            const std::vector<logic::Fact>& batch, TickRecord& record);
  void Silence(std::uint64_t tick);

  std::vector<config::Wire> wires_;  ///< That start at a layer.
  std::vector<config::Inhibition> inhibitions_;
  std::vector<LayerState> layers_;
  std::vector<Spoken> sensors_;
  std::vector<EffectorState> effectors_;
  std::vector<sdk::Batch> commands_;
  sdk::Batch handed_;
};

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_ARBITRATION_H_
