// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_CLAUSE_INSTANCE_H_
#define LATCHWORK_PTTP_CLAUSE_INSTANCE_H_

#include <cstdint>
#include <vector>

#include "latchwork/logic/clause.h"

namespace latchwork::pttp {

/// One more or less instantiated clause of a refutation. Variables that are left are numbered
/// across all instances of the refutation.
struct ClauseInstance {
  std::uint32_t clause = 0;  ///< Index among the clauses that were searched.
  std::vector<logic::Literal> literals;
  std::vector<logic::Term> values;  ///< Of the clause's variables.
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_CLAUSE_INSTANCE_H_
