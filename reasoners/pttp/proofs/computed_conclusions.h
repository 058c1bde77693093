// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_COMPUTED_CONCLUSIONS_H_
#define LATCHWORK_PTTP_COMPUTED_CONCLUSIONS_H_

#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::pttp {

/// Whether the term is an interpreted function of something, as $sum(X, 1).
bool IsComputed(const logic::Term& term);

/// The clauses with conclusions that match before they are computed: `level($sum(X, 1))` becomes
/// `level(V1)`, and `V1 = $sum(X, 1)` is what is left to show.
std::vector<logic::Clause> WithComputedConclusions(std::span<const logic::Clause> clauses,
                                                   logic::SymbolTable& symbols);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_COMPUTED_CONCLUSIONS_H_
