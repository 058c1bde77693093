// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_EACH_STATE_H_
#define LATCHWORK_SCHEDULE_EACH_STATE_H_

#include <cstdint>
#include <span>
#include <vector>

#include "latchwork/sdk/decision.h"
#include "latchwork/sdk/reasoner.h"

namespace latchwork::schedule {

/// Decisions of a reasoner that knows decided latch facts only, under undecided ones: it decides
/// once for each state that they may be in; what it concludes in all of them is concluded, what in
/// some is undecided. Source: LSA, section 3.3. Not thread-safe.
class EachState {
 public:
  static constexpr std::size_t kMostStates = 64;

  /// As Reasoner::Decide. The states share the budget. More than kMostStates: unknown.
  void Decide(sdk::Reasoner& reasoner, std::span<const sdk::Latch> latches,
              const sdk::Budget& budget, sdk::Decision& decision);

 private:
  /// A conclusion, and in which states it was drawn; in others it may be undecided.
  struct Drawn {
    sdk::Conclusion conclusion;
    sdk::GoalState states;
  };

  bool ListStates(std::span<const sdk::Latch> latches);
  void Show(std::span<const sdk::Latch> latches, std::size_t state);
  /// False: the decision for all states is made; it is no good.
  bool Add(std::size_t state, sdk::Decision& decision);
  Drawn& Find(const sdk::Conclusion& conclusion);
  void AddConclusion(std::size_t state, const sdk::Conclusion& conclusion, sdk::Decision& decision);
  std::size_t AddAssumption(const sdk::Assumption& assumption, sdk::Decision& decision);
  void Finish(sdk::Decision& decision);

  std::vector<std::vector<sdk::GoalState>> choices_;  ///< By latch.
  std::size_t states_ = 0;                            ///< Ways to choose one of each.
  std::vector<sdk::Latch> shown_;
  std::uint64_t shows_ = 0;
  sdk::Decision one_;  ///< Of one state.
  std::vector<Drawn> drawn_;
  bool states_known_ = true;  ///< In each state, what was not drawn does not hold.
};

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_EACH_STATE_H_
