// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_CLAUSIFY_H_
#define LATCHWORK_LOGIC_CLAUSIFY_H_

#include <cstddef>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/clause_origins.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/formula.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::logic {

struct ClausifyOptions {
  /// A disjunction whose distribution would give more clauses than this is named by a fresh
  /// definition (Plaisted and Greenbaum 1986: only in the polarity in which it occurs).
  std::size_t distribution_limit = 24;
  /// Symbols that all clauses together may be written with; bounds time and memory.
  std::size_t max_symbols = 50'000'000;
};

/// Clauses equisatisfiable with the formulas: negation normal form, miniscoping, Skolemization with
/// fresh functions of the free variables, distribution or definitions. Conjectures are negated
/// together (all of them must be proved; their negations form one disjunction) and come out as
/// kNegatedConjecture. Tautologies are dropped, duplicate literals merged; clause order follows
/// formula order. Where `origins` is given, it gets the steps that led to the clauses.
std::vector<Clause> Clausify(const std::vector<AnnotatedFormula>& formulas, SymbolTable& symbols,
                             const ClausifyOptions& options = {},
                             Diagnostics* diagnostics = nullptr, ClauseOrigins* origins = nullptr);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_CLAUSIFY_H_
