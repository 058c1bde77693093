// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_GROUNDING_TPTP_PROBLEM_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_GROUNDING_TPTP_PROBLEM_H_

#include <cstddef>
#include <string>
#include <vector>

#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/formula.h"
#include "latchwork/logic/symbol.h"
#include "reasoners/circumscription/formats/circ_file.h"
#include "reasoners/circumscription/grounding/grounder.h"

namespace latchwork::circumscription {

struct GroundingLimits {
  std::size_t atoms_of_formula = 100'000;  ///< Of one formula, its quantifiers written out.
  std::size_t steps = 20'000'000;          ///< Of matching and enumerating.
};

/// A theory with finite domain, ground, and what is asked of it.
struct TptpProblem {
  GroundTheory theory;
  std::vector<Query> queries;      ///< One for each conjecture, in order; each of one literal.
  logic::Diagnostics diagnostics;  ///< Where there are any, the rest must not be used.
};

/// Grounds the axioms over the constants that occur in `formulas`, axioms and conjectures alike:
/// they are taken to be all different, and all there is. Where none occurs there is one thing
/// without a name. All conjectures are asked of this one domain: a constant that only one of them
/// names is there for the others, too. Conjectures become queries, named as they are. A formula
/// with a function symbol or arithmetic is refused, with its place and the reason.
TptpProblem GroundTptp(const std::vector<logic::AnnotatedFormula>& formulas,
                       const PredicateRoles& roles, logic::SymbolTable& symbols,
                       const GroundingLimits& limits = {});

/// The predicates that occur in the formulas, in order; equality is none.
std::vector<logic::PredicateName> PredicatesOf(
    const std::vector<logic::AnnotatedFormula>& formulas);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_GROUNDING_TPTP_PROBLEM_H_
