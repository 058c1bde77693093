// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_CHECK_PROOF_GROUND_ARITHMETIC_H_
#define LATCHWORK_APPS_CHECK_PROOF_GROUND_ARITHMETIC_H_

#include "apps/check_proof/clause_match.h"
#include "latchwork/logic/formula.h"

namespace latchwork::check_proof {

/// Whether a clause is true by arithmetic: one of its literals is, or two of them say the opposite
/// once their terms are computed. Numerals are the decimal numbers that they are written as, and
/// nothing is rounded. kTooHard: a term is too deep, or a number too large.
Verdict IsTrueByArithmetic(const logic::Formula& clause);

}  // namespace latchwork::check_proof

#endif  // LATCHWORK_APPS_CHECK_PROOF_GROUND_ARITHMETIC_H_
