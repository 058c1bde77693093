// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_LAYERS_LATCH_FACTS_H_
#define LATCHWORK_OMPL_LAYERS_LATCH_FACTS_H_

#include <algorithm>
#include <span>

#include "latchwork/sdk/reasoner.h"

namespace latchwork::planning {

/// What the latches of a cycle say, by predicate, whichever port it came by.
class LatchFacts {
 public:
  explicit LatchFacts(std::span<const sdk::Latch> latches) : latches_(latches) {}

  /// Calls `visit` with the arguments of every fact of the predicate.
  template <typename Visit>
  void ForEach(logic::PredicateName name, Visit visit) const {
    for (const sdk::Latch& latch : latches_) {
      for (const logic::Fact& fact : latch.facts) {
        if (logic::NameOf(fact) == name) visit(fact.arguments());
      }
    }
  }
  /// The first fact of the predicate, or none.
  const logic::Fact* First(logic::PredicateName name) const {
    for (const sdk::Latch& latch : latches_) {
      for (const logic::Fact& fact : latch.facts) {
        if (logic::NameOf(fact) == name) return &fact;
      }
    }
    return nullptr;
  }
  bool Holds(const logic::Fact& wanted) const {
    return std::any_of(latches_.begin(), latches_.end(), [&](const sdk::Latch& latch) {
      return std::find(latch.facts.begin(), latch.facts.end(), wanted) != latch.facts.end();
    });
  }

 private:
  std::span<const sdk::Latch> latches_;
};

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_LAYERS_LATCH_FACTS_H_
