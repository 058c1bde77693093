// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_NAME_SUBFORMULAS_H_
#define LATCHWORK_LOGIC_NAME_SUBFORMULAS_H_

#include <cstddef>
#include <vector>

#include "core/logic/miniscope.h"
#include "core/logic/normal_tree.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::logic {

/// A fresh atom that stands for a subformula.
struct SubformulaName {
  NormalTree::Id name = 0;  ///< A positive literal.
  NormalTree::Id body = 0;
  bool in_both_polarities = false;
};

/// Replaces subformulas by names where distribution would make too many clauses of them, or copy
/// them too often: a disjunction may give `limit` clauses, and literals about as many as the
/// formula has. `free` is kept up to date when it is there. Source: Plaisted and Greenbaum 1986;
/// counting as in Nonnengart and Weidenbach 2001, section 4.
std::vector<SubformulaName> NameSubformulas(NormalTree& tree, FreeVariableTable* free,
                                            std::size_t limit, SymbolTable& symbols);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_NAME_SUBFORMULAS_H_
