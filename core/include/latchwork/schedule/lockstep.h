// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_LOCKSTEP_H_
#define LATCHWORK_SCHEDULE_LOCKSTEP_H_

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/schedule/agent.h"
#include "latchwork/schedule/statistics.h"
#include "latchwork/schedule/tick_record.h"

namespace latchwork::schedule {

struct LockstepOptions {
  unsigned threads = 1;  ///< That decide layers; the result does not depend on it.
  std::optional<std::uint64_t> max_ticks{};  ///< Instead of the description's.
  /// A cycle that takes longer is cancelled: a fault of the layer.
  std::chrono::milliseconds wall_limit{10'000};
  /// A reasoner that ignores the cancellation for so long cannot be contained within the process.
  std::chrono::milliseconds grace{10'000};
  /// What to do then; called by the watchdog's thread. Nothing given: says plugin and tick on
  /// standard error and ends the process with exit code 5 (the journal is whole up to the tick
  /// before).
  std::function<void(std::string_view plugin, std::uint64_t tick)> on_hang{};
  std::vector<RunObserver*> observers{};  ///< Told in this order; not owned.
};

/// Runs an agent tick by tick; a run is a function of agent and seed. What is visible when:
/// docs/tick.md. Thread rule: used by one thread; it starts its own.
class Lockstep {
 public:
  explicit Lockstep(Agent agent, LockstepOptions options = {});
  ~Lockstep();
  Lockstep(const Lockstep&) = delete;
  Lockstep& operator=(const Lockstep&) = delete;

  /// One tick. False when the run is over: reached, failed, stopped or out of ticks. Once it is,
  /// nothing happens.
  bool Tick();
  /// All ticks that are left, then the observers' OnEnd.
  RunResult Run();

  /// Of the ticks so far.
  RunResult Result() const;
  const Agent& agent() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_LOCKSTEP_H_
