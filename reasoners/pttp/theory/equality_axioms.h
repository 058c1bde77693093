// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_EQUALITY_AXIOMS_H_
#define LATCHWORK_PTTP_EQUALITY_AXIOMS_H_

#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::pttp {

/// X = X, which the machine of the control loop has built in.
logic::Clause Reflexivity(logic::SymbolTable& symbols);

/// Symmetry, transitivity and substitution for every function and predicate of the clauses and of
/// `facts`, when a clause can conclude an equation; none otherwise.
std::vector<logic::Clause> EqualityAxioms(std::span<const logic::Clause> clauses,
                                          std::span<const logic::Fact> facts,
                                          logic::SymbolTable& symbols);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_EQUALITY_AXIOMS_H_
