// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PLAN_SPACE_H_
#define LATCHWORK_PTTP_PLAN_SPACE_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "reasoners/pttp/plans/fluent_queries.h"
#include "reasoners/pttp/plans/situation_rules.h"
#include "reasoners/pttp/plans/situations.h"
#include "reasoners/pttp/theory/predicates.h"
#include "reasoners/pttp/theory/reach.h"

namespace latchwork::pttp {

/// What a reach says about situations, and the situations of the present decision.
class PlanSpace {
 public:
  PlanSpace(const Predicates& predicates, const Reach& reach) : rules_(predicates, reach) {}
  PlanSpace(const PlanSpace&) = delete;
  PlanSpace& operator=(const PlanSpace&) = delete;
  ~PlanSpace() = default;

  const SituationRules& rules() const { return rules_; }
  Situations& situations() { return situations_; }
  /// One for each rule; made when they are first needed.
  std::vector<std::unique_ptr<FluentQueries>>& queries() { return queries_; }

  /// Too much holds somewhere to be listed; that is not tried again.
  bool hopeless = false;
  std::uint64_t decision = 0;  ///< For which the situations were made.
  bool made = false;           ///< They were.

 private:
  SituationRules rules_;
  Situations situations_{rules_};
  std::vector<std::unique_ptr<FluentQueries>> queries_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PLAN_SPACE_H_
