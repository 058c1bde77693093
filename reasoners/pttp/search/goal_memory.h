// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_GOAL_MEMORY_H_
#define LATCHWORK_PTTP_GOAL_MEMORY_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "latchwork/sdk/decision.h"
#include "reasoners/pttp/search/engine.h"
#include "reasoners/pttp/theory/predicate_set.h"

namespace latchwork::pttp {

/// When a result was found and what it rests on: it stands until one of those predicates' facts
/// change.
class Validity {
 public:
  void Void() { set_ = false; }
  void Set(Engine& engine) {
    set_ = true;
    seen_ = engine.Seen();
    time_ = engine.now();
    reach_version_ = engine.reach_version();
  }
  bool Holds(const Engine& engine) const {
    return set_ && reach_version_ == engine.reach_version() && !engine.HasChanged(seen_, time_);
  }

 private:
  bool set_ = false;
  PredicateSet seen_;
  std::uint64_t time_ = 0;
  std::uint64_t reach_version_ = 0;
};

/// What a goal came to when it was last decided; its memory is reused.
struct GoalMemory {
  Validity validity;
  std::size_t conclusion_count = 0;
  std::vector<sdk::Conclusion> conclusions;  ///< Their assumptions are indices into `assumptions`.
  std::size_t assumption_count = 0;
  std::vector<sdk::Assumption> assumptions;
  std::uint32_t depth = 0;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_GOAL_MEMORY_H_
