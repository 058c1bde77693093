// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_SPENDING_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_SPENDING_H_

#include <cstdint>

#include "latchwork/sdk/decision.h"

namespace latchwork::circumscription {

/// What a decision has spent of its budget, on evaluation and on search.
class Spending {
 public:
  void Begin(const sdk::Budget& budget) {
    budget_ = budget;
    inferences_ = 0;
    attachment_calls = 0;
    limit_ = sdk::Limit::kNone;
  }
  void Infer() {
    if (++inferences_ >= budget_.inferences) limit_ = sdk::Limit::kInferences;
    if (inferences_ % kPoll == 0) Poll();
  }
  /// A step of a search, which takes longer than an inference.
  void Step() {
    if (is_spent()) return;
    Infer();
    if (!is_spent()) Poll();
  }
  bool is_spent() const { return limit_ != sdk::Limit::kNone; }
  sdk::Limit limit() const { return limit_; }
  std::uint64_t inferences() const { return inferences_; }
  std::uint64_t attachment_calls = 0;

 private:
  static constexpr std::uint64_t kPoll = 1024;

  void Poll() {
    if (budget_.cancelled != nullptr && budget_.cancelled->load(std::memory_order_relaxed)) {
      limit_ = sdk::Limit::kCancelled;
    } else if (budget_.deadline && std::chrono::steady_clock::now() >= *budget_.deadline) {
      limit_ = sdk::Limit::kTime;
    }
  }

  sdk::Budget budget_;
  std::uint64_t inferences_ = 0;
  sdk::Limit limit_ = sdk::Limit::kNone;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_SPENDING_H_
