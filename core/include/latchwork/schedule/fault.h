// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_FAULT_H_
#define LATCHWORK_SCHEDULE_FAULT_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace latchwork::schedule {

/// In which way a part did not do what its interface asks.
enum class FaultKind : std::uint8_t {
  kException,      ///< It threw.
  kTimeout,        ///< The watchdog had to cancel it.
  kOverBudget,     ///< It spent more inferences than it was given.
  kInconsistent,   ///< Body and latches contradict each other.
  kFailed,         ///< The reasoner says that it could not work.
  kBadConclusion,  ///< A conclusion breaks the contract: unknown predicate, wrong type, NaN, …
  kAdmission,      ///< It threw while it checked a batch.
};

std::string_view Name(FaultKind kind);

/// A fault that was contained. A layer answers with its fallback; a fault of the world ends the
/// run.
struct Fault {
  static constexpr std::size_t kWorld = static_cast<std::size_t>(-1);

  std::uint64_t tick = 0;
  std::size_t layer = kWorld;  ///< Index into the description's layers, or kWorld.
  std::string plugin;          ///< Of the reasoner or world at fault.
  FaultKind kind = FaultKind::kException;
  std::string message;
};

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_FAULT_H_
