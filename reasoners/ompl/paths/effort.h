// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_PATHS_EFFORT_H_
#define LATCHWORK_OMPL_PATHS_EFFORT_H_

#include <algorithm>
#include <cstdint>

#include "latchwork/sdk/decision.h"

namespace latchwork::planning {

/// What planners have spent in one decision. It is counted in states and motions checked and in
/// rounds of the planners, never in time, so that runs repeat; the clock is looked at only where
/// the budget has a deadline.
class Effort {
 public:
  explicit Effort(const sdk::Budget& budget) : budget_(&budget) {}

  /// False, and nothing is counted: the inferences are spent, so the check must not be made.
  bool Spend() {
    if (spent_ >= budget_->inferences) return false;
    ++spent_;
    return true;
  }
  std::uint64_t spent() const { return spent_; }
  std::uint64_t left() const { return budget_->inferences - std::min(spent_, budget_->inferences); }
  /// Whether to stop now; kNone: go on.
  sdk::Limit limit() const {
    if (spent_ >= budget_->inferences) return sdk::Limit::kInferences;
    if (budget_->cancelled != nullptr && budget_->cancelled->load(std::memory_order_relaxed)) {
      return sdk::Limit::kCancelled;
    }
    if (budget_->deadline && std::chrono::steady_clock::now() >= *budget_->deadline) {
      return sdk::Limit::kTime;
    }
    return sdk::Limit::kNone;
  }

 private:
  const sdk::Budget* budget_;
  std::uint64_t spent_ = 0;
};

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_PATHS_EFFORT_H_
