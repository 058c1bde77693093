// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_CHECK_PROOF_PROPOSITIONAL_H_
#define LATCHWORK_APPS_CHECK_PROOF_PROPOSITIONAL_H_

#include <vector>

#include "apps/check_proof/clause_match.h"
#include "latchwork/logic/clause.h"

namespace latchwork::check_proof {

/// Whether clauses contradict each other by propositional logic alone, with variables taken for
/// constants that all clauses share.
Verdict Contradict(const std::vector<std::vector<logic::Literal>>& clauses);

}  // namespace latchwork::check_proof

#endif  // LATCHWORK_APPS_CHECK_PROOF_PROPOSITIONAL_H_
