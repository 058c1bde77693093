// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_FLUENT_QUERIES_H_
#define LATCHWORK_PTTP_FLUENT_QUERIES_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "reasoners/pttp/plans/situation_rules.h"
#include "reasoners/pttp/search/query.h"
#include "reasoners/pttp/terms/arena.h"

namespace latchwork::pttp {

/// A fluent rule with its situations left out, and the queries that find its instances: fluents
/// are looked up as facts of stand-ins. The slots that the body binds come first.
struct FluentQueries {
  const FluentRule* rule = nullptr;
  std::uint32_t bound = 0;  ///< How many slots the body binds.
  std::uint32_t slots = 0;
  std::vector<Word> head;               ///< Arguments.
  std::vector<Word> action;             ///< Arguments; a successor rule's.
  Word about = 0;                       ///< The header of the action, or the initial situation.
  std::vector<std::vector<Word>> body;  ///< Arguments of the fluents.
  /// One for each fluent, which comes first there and is a new one; without fluents, one.
  std::vector<std::unique_ptr<Query>> queries;
  Arena terms;
};

/// What a fluent is looked up as: all that hold somewhere, and those found last.
struct StandIns {
  PredicateId all = 0;
  PredicateId fresh = 0;
};

/// `stand_ins`: by predicate.
std::unique_ptr<FluentQueries> MakeFluentQueries(const SituationRules& rules,
                                                 const FluentRule& rule,
                                                 const std::vector<StandIns>& stand_ins);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_FLUENT_QUERIES_H_
