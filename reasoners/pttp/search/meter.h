// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_METER_H_
#define LATCHWORK_PTTP_METER_H_

#include <algorithm>
#include <cstdint>

#include "latchwork/sdk/decision.h"

namespace latchwork::pttp {

/// What a decision has spent and may spend. The clock and the cancellation flag are looked at every
/// kPollPeriod steps, the clock only when there is a deadline.
class Meter {
 public:
  void Start(const sdk::Budget& budget) {
    budget_ = budget;
    inferences_ = 0;
    work_ = 0;
    ceiling_ = budget.inferences;
    limit_ = sdk::Limit::kNone;
    Poll();
  }

  /// Counts an extension or reduction step that succeeded.
  void CountInference() {
    if (++inferences_ >= ceiling_) Stop(sdk::Limit::kInferences);
  }
  /// Counts a step that was tried.
  void CountWork() {
    if (++work_ % kPollPeriod == 0) Poll();
  }
  void Stop(sdk::Limit limit) {
    if (limit_ == sdk::Limit::kNone) limit_ = limit;
  }

  bool stopped() const { return limit_ != sdk::Limit::kNone; }
  sdk::Limit limit() const { return limit_; }
  std::uint64_t inferences() const { return inferences_; }
  std::uint64_t work() const { return work_; }
  const sdk::Budget& budget() const { return budget_; }

  /// Lets what follows spend at most so many inferences more.
  void LowerCeiling(std::uint64_t more) {
    ceiling_ = std::min(budget_.inferences, inferences_ + more);
  }
  /// Ends what LowerCeiling began. True when the lowered ceiling was what stopped it; then work may
  /// go on.
  bool RestoreCeiling() {
    const bool lowered = limit_ == sdk::Limit::kInferences && inferences_ < budget_.inferences;
    ceiling_ = budget_.inferences;
    if (lowered) limit_ = sdk::Limit::kNone;
    return lowered;
  }

 private:
  static constexpr std::uint64_t kPollPeriod = 256;

  void Poll() {
    if (budget_.cancelled != nullptr && budget_.cancelled->load(std::memory_order_relaxed)) {
      Stop(sdk::Limit::kCancelled);
    } else if (budget_.deadline && std::chrono::steady_clock::now() >= *budget_.deadline) {
      Stop(sdk::Limit::kTime);
    }
  }

  sdk::Budget budget_;
  std::uint64_t inferences_ = 0;
  std::uint64_t ceiling_ = 0;
  std::uint64_t work_ = 0;
  sdk::Limit limit_ = sdk::Limit::kNone;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_METER_H_
