// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_CHECK_PROOF_ENTAILMENT_H_
#define LATCHWORK_APPS_CHECK_PROOF_ENTAILMENT_H_

#include <vector>

#include "apps/check_proof/clause_match.h"
#include "latchwork/logic/formula.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::check_proof {

/// Whether closed formulas entail another, as far as the small prover reaches.
Verdict Entails(const std::vector<const logic::AnnotatedFormula*>& premises,
                const logic::Formula& conclusion, logic::SymbolTable& symbols);

/// Whether a clause follows from formulas that are clauses by propositional logic alone, where
/// variables of the same name are one. kTooHard where one of them is no clause.
Verdict EntailsAsClauses(const std::vector<const logic::AnnotatedFormula*>& premises,
                         const logic::AnnotatedFormula& conclusion);

/// The literals of a disjunction below universal quantifiers; false when it is something else.
bool ToLiterals(const logic::Formula& formula, std::vector<logic::Literal>& literals);

}  // namespace latchwork::check_proof

#endif  // LATCHWORK_APPS_CHECK_PROOF_ENTAILMENT_H_
