// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_LAYER_TALLY_H_
#define LATCHWORK_SCHEDULE_LAYER_TALLY_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/schedule/statistics.h"
#include "latchwork/sdk/decision.h"

namespace latchwork::schedule {

/// Counts what a layer does. Keeps every sample, so that percentiles are exact.
class LayerTally {
 public:
  /// `decisions`: how many to make room for.
  explicit LayerTally(std::size_t decisions);

  void CountDecision(const sdk::Decision& decision, std::chrono::nanoseconds wall);
  void CountFault() { ++faults_; }
  void CountRefused(std::size_t facts) { refused_ += facts; }

  /// Everything but the names.
  LayerStatistics Sum() const;

 private:
  void CountAssumptions(const std::vector<sdk::Assumption>& assumptions);

  std::vector<double> time_us_;
  std::vector<double> inferences_;
  std::vector<logic::Fact> assumed_;  ///< In the last decision; sorted.
  std::uint64_t budget_hits_ = 0;
  std::uint64_t retracted_ = 0;
  std::uint64_t assumed_by_bound_ = 0;
  std::uint64_t faults_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_LAYER_TALLY_H_
