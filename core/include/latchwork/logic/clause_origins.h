// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_CLAUSE_ORIGINS_H_
#define LATCHWORK_LOGIC_CLAUSE_ORIGINS_H_

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/formula.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::logic {

/// How clauses came about, step by step, for whoever has to show it. Formulas written as clauses
/// need no steps and have none here.
struct ClauseOrigins {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  /// `! [X] : (name(X) <=> body)` for a name that nothing before it uses. A body may hold names
  /// that were defined before.
  struct Definition {
    Symbol name;
    Formula formula;
    std::vector<std::string> variable_names;
  };

  /// One formula on its way to clauses.
  struct NormalForm {
    std::size_t formula = kNone;     ///< Index of the formula that it follows from, else kNone.
    std::size_t definition = kNone;  ///< Index of the definition that it follows from, else kNone.
    /// In negation normal form with quantifiers moved inwards and subformulas replaced by their
    /// names: a consequence of the formula (negated, if it is a conjecture) and the definitions of
    /// its names. Neither index: of the negated conjunction of all conjectures.
    Formula normal;
    std::vector<std::string> normal_names;
    /// The same with Skolem terms for existential variables.
    Formula skolemized;
    std::vector<std::string> skolemized_names;
    std::vector<Symbol> skolem_functions;
    std::vector<Clause> clauses;  ///< Consequences of `skolemized`.
  };

  std::vector<Definition> definitions;
  std::vector<NormalForm> normal_forms;
};

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_CLAUSE_ORIGINS_H_
