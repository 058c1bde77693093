// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PROOF_PREMISE_H_
#define LATCHWORK_PTTP_PROOF_PREMISE_H_

#include <string_view>

#include "reasoners/pttp/proofs/clause_instance.h"

namespace latchwork::pttp {

/// One of the clauses that contradict each other in a refutation by propositional logic alone: an
/// instance of a clause, or a single literal that a built-in theory makes true.
struct ProofPremise {
  ClauseInstance instance;
  std::string_view theory;  ///< Empty: an instance of a clause.
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PROOF_PREMISE_H_
