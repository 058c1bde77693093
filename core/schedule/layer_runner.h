// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_LAYER_RUNNER_H_
#define LATCHWORK_SCHEDULE_LAYER_RUNNER_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/schedule/each_state.h"
#include "core/schedule/latch_set.h"
#include "core/schedule/layer_tally.h"
#include "core/schedule/port_contract.h"
#include "core/schedule/watchdog.h"
#include "latchwork/schedule/agent.h"
#include "latchwork/schedule/fault.h"
#include "latchwork/sdk/decision.h"
#include "latchwork/sdk/world.h"

namespace latchwork::schedule {

/// Runs the cycles of one layer: settles its latches, lets the reasoner decide, checks the
/// conclusions, and has the fallback ready when anything goes wrong. Everything it writes is its
/// own, so that the layers of a tick may run in parallel. Thread rule: used by one thread at a
/// time.
class LayerRunner {
 public:
  /// `agent` and `watchdog` outlive the runner; `index` is also its place with the watchdog.
  LayerRunner(const Agent& agent, std::size_t index, Watchdog& watchdog);

  bool IsDue(std::uint64_t tick) const;
  LatchSet& latches() { return latches_; }
  /// One cycle; contains everything that the reasoner may throw.
  void Cycle(std::uint64_t tick);

  // Of the last cycle:
  const Settlement& settlement() const { return settlement_; }
  const sdk::Decision& decision() const { return decision_; }
  const std::vector<Fault>& faults() const { return faults_; }
  const std::vector<sdk::Batch>& said() const { return said_; }
  std::chrono::nanoseconds wall() const { return wall_; }

  LayerStatistics Statistics() const;

 private:
  struct Problem {
    FaultKind kind;
    std::string message;
  };

  void Decide();
  std::optional<Problem> Judge(bool cancelled) const;
  std::optional<Problem> JudgeConclusions() const;
  std::optional<Problem> JudgeConclusion(const sdk::Conclusion& each) const;
  void Say(bool fallback);
  void SayUndecided();
  void AddFault(std::uint64_t tick, FaultKind kind, std::string message);

  const config::LayerDescription& description_;
  const AgentLayer& layer_;
  std::size_t index_;
  Watchdog& watchdog_;
  sdk::Budget budget_;
  LatchSet latches_;
  EachState each_state_;
  std::vector<PortContract> outputs_;
  LayerTally tally_;

  Settlement settlement_;
  sdk::Decision decision_;
  std::optional<std::string> thrown_;
  std::vector<Fault> faults_;
  std::vector<sdk::Batch> said_;
  std::chrono::nanoseconds wall_{0};
};

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_LAYER_RUNNER_H_
