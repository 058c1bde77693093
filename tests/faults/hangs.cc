// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <thread>

#include "tests/faults/fault_reasoner.h"

namespace latchwork::faults {
namespace {

/// Finds nothing for as long as it may search: until it is cancelled or its deadline comes. Where
/// it has neither, until its inferences are used up.
class Hangs : public FaultReasoner {
 protected:
  void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) override {
    decision.conclusions.clear();
    decision.status = sdk::Status::kUnknown;
    decision.statistics = {};
    const bool has_clock = budget.deadline.has_value() || budget.cancelled != nullptr;
    if (!has_clock) decision.statistics.inferences = budget.inferences;
    while ((decision.limit = Reached(budget)) == sdk::Limit::kNone) {
      if (!has_clock) {
        decision.limit = sdk::Limit::kInferences;
        return;
      }
      std::this_thread::yield();
    }
  }

 private:
  static sdk::Limit Reached(const sdk::Budget& budget) {
    if (budget.cancelled != nullptr && budget.cancelled->load()) return sdk::Limit::kCancelled;
    if (budget.deadline && std::chrono::steady_clock::now() >= *budget.deadline) {
      return sdk::Limit::kTime;
    }
    return sdk::Limit::kNone;
  }
};

}  // namespace
}  // namespace latchwork::faults

LATCHWORK_PLUGIN(latchwork::faults::Hangs, "hangs", "1.0", "searches until it is stopped")
