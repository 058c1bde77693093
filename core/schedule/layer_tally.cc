// SPDX-License-Identifier: BSD-3-Clause
#include "core/schedule/layer_tally.h"

#include <algorithm>

namespace latchwork::schedule {
namespace {

constexpr std::size_t kMostReserved = 1U << 16U;

}  // namespace

LayerTally::LayerTally(std::size_t decisions) {
  time_us_.reserve(std::min(decisions, kMostReserved));
  inferences_.reserve(std::min(decisions, kMostReserved));
}

void LayerTally::CountDecision(const sdk::Decision& decision, std::chrono::nanoseconds wall) {
  time_us_.push_back(std::chrono::duration<double, std::micro>(wall).count());
  inferences_.push_back(static_cast<double>(decision.statistics.inferences));
  if (decision.limit != sdk::Limit::kNone) ++budget_hits_;
  CountAssumptions(decision.assumptions);
}

void LayerTally::CountAssumptions(const std::vector<sdk::Assumption>& assumptions) {
  using State = sdk::Assumption::State;
  for (const sdk::Assumption& each : assumptions) {
    if (each.state == State::kMadeByBound) ++assumed_by_bound_;
    if (each.state == State::kRetracted &&
        std::binary_search(assumed_.begin(), assumed_.end(), each.atom)) {
      ++retracted_;
    }
  }
  assumed_.clear();
  for (const sdk::Assumption& each : assumptions) {
    if (each.state != State::kRetracted) assumed_.push_back(each.atom);
  }
  std::sort(assumed_.begin(), assumed_.end());
}

LayerStatistics LayerTally::Sum() const {
  LayerStatistics sum;
  sum.decisions = time_us_.size();
  sum.time_us = Describe(time_us_);
  sum.inferences = Describe(inferences_);
  sum.budget_hits = budget_hits_;
  sum.retracted = retracted_;
  sum.assumed_by_bound = assumed_by_bound_;
  sum.faults = faults_;
  sum.refused = refused_;
  return sum;
}

}  // namespace latchwork::schedule
