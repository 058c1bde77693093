// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_CHECK_PROOF_SMALL_PROVER_H_
#define LATCHWORK_APPS_CHECK_PROOF_SMALL_PROVER_H_

#include <vector>

#include "apps/check_proof/clause_match.h"
#include "latchwork/logic/clause.h"

namespace latchwork::check_proof {

/// Whether clauses, each with variables of its own and `=` for equality, contradict each other: by
/// superposition, first with a negative literal selected in every clause that has one, with
/// rewriting, unit cuts and subsumption, smallest clause first, so far as a bounded number of
/// clauses reaches. For the single steps of a proof, not for whole ones. Numbers, and distinct
/// objects, are unequal.
Verdict Refute(const std::vector<std::vector<logic::Literal>>& clauses);

}  // namespace latchwork::check_proof

#endif  // LATCHWORK_APPS_CHECK_PROOF_SMALL_PROVER_H_
