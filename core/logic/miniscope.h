// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_MINISCOPE_H_
#define LATCHWORK_LOGIC_MINISCOPE_H_

#include <optional>
#include <vector>

#include "core/logic/normal_tree.h"

namespace latchwork::logic {

/// The free variables of every node of a tree, each list ascending.
using FreeVariableTable = std::vector<std::vector<Variable>>;

/// Moves every quantifier inwards as far as its variable's occurrences allow, without copies of it
/// and without touching the order of children, so that Skolem functions get fewer arguments. Each
/// quantifier then binds one variable. Gives the table of what is free in which node; or nothing,
/// and leaves the tree alone, when the table would take more memory than is reasonable.
std::optional<FreeVariableTable> Miniscope(NormalTree& tree);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_MINISCOPE_H_
