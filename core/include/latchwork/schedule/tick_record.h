// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_TICK_RECORD_H_
#define LATCHWORK_SCHEDULE_TICK_RECORD_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "latchwork/config/agent.h"
#include "latchwork/logic/atom.h"
#include "latchwork/schedule/fault.h"
#include "latchwork/schedule/statistics.h"
#include "latchwork/sdk/decision.h"
#include "latchwork/sdk/world.h"

namespace latchwork::schedule {

/// An exogenous event, and why the world could not do it (else empty).
struct EventRecord {
  logic::Fact fact;
  std::string problem;
};

/// A latch whose content changed when its layer's cycle began.
struct LatchRecord {
  std::size_t layer = 0;
  std::size_t port = 0;
  std::uint64_t version = 0;
  bool stale = false;  ///< Emptied because its source was silent for too long.
  std::span<const logic::Fact> facts;
  const sdk::Undecided* undecided = nullptr;  ///< What may hold besides; never null in a run.
};

/// A fact that was kept out of a latch or away from an effector.
struct RefusalRecord {
  config::PortAddress to;
  logic::Fact fact;
  std::string reason;
};

/// One cycle of a layer.
struct DecisionRecord {
  std::size_t layer = 0;
  const sdk::Decision* decision = nullptr;
  bool fallback = false;             ///< A fault: what follows was said instead.
  std::span<const sdk::Batch> said;  ///< One batch per output port.
  std::chrono::nanoseconds wall{0};  ///< Of Decide; differs from run to run.
};

/// What happened in one tick. Spans and pointers are valid during RunObserver::OnTick only.
struct TickRecord {
  std::uint64_t tick = 0;
  std::vector<EventRecord> events;
  std::span<const sdk::Batch>
      sensors;  ///< By the world's output ports; only the updated ones were said in this tick.
  std::vector<LatchRecord> latched;
  std::vector<RefusalRecord> refused;
  std::vector<DecisionRecord> decisions;       ///< Of the layers due, in declared order.
  std::vector<config::PortAddress> inhibited;  ///< Outputs that were kept from leaving.
  std::span<const sdk::Batch> commands;        ///< By the world's input ports.
  std::vector<Fault> faults;
};

/// Watches a run. Called by the thread that runs it, after the world's step.
class RunObserver {
 public:
  virtual ~RunObserver() = default;
  /// False ends the run after this tick.
  virtual bool OnTick(const TickRecord& record) = 0;
  virtual void OnEnd(const RunResult& result) { static_cast<void>(result); }
};

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_TICK_RECORD_H_
