// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_QUERY_H_
#define LATCHWORK_PTTP_QUERY_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/term.h"
#include "reasoners/pttp/plans/situation_rules.h"
#include "reasoners/pttp/search/machine.h"
#include "reasoners/pttp/tables/table_plan.h"
#include "reasoners/pttp/terms/arena.h"

namespace latchwork::pttp {

class PlanSpace;

/// A start clause with what the engine found out about it; kept from cycle to cycle.
struct Query {
  Contrapositive clause;
  Arena terms;            ///< Of the clause, where it has its own.
  bool closing = true;    ///< Minimized predicates are closed.
  bool is_given = false;  ///< All variables have values when it is asked.

  // The engine's; valid while `reach_version` is the engine's.
  std::uint64_t reach_version = 0;
  const Reach* reach = nullptr;
  TableProgram* program = nullptr;
  TablePlan plan;
  bool fits = false;  ///< The plan may be used.
  PlanSpace* plan_space = nullptr;
  SituationUse use;  ///< Of the plan space.
  SearchRequest request;
};

/// What an attachment asked, with the answers of the present decision.
struct AskedQuery {
  std::vector<logic::Literal> literals;
  std::size_t variables = 0;
  Query query;
  std::uint64_t decision = 0;  ///< In which the answers were found.
  bool answered = false;       ///< They are all there are.
  std::size_t count = 0;
  std::vector<logic::Term> answers;  ///< `variables` terms each.
  std::vector<std::size_t> assumptions;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_QUERY_H_
