// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_UNIT_CHAIN_H_
#define LATCHWORK_PTTP_UNIT_CHAIN_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace latchwork::pttp {

/// A literal of propositional logic: twice the number of its atom, and one more where negated.
using PropositionalLiteral = std::uint32_t;
using PropositionalClause = std::vector<PropositionalLiteral>;

/// A clause that follows from others by unit propagation: with all its literals false, one parent
/// after the other has at most one literal left, and the last one none.
struct ChainStep {
  PropositionalClause clause;
  /// What it follows from: a premise by its number, or the premises' number plus an earlier step's.
  std::vector<std::size_t> parents;
};

struct ChainLimits {
  std::size_t parents = 16;       ///< Of a step, where the premises are no longer than that.
  std::size_t conflicts = 20000;  ///< That a refutation may take to find.
};

/// Breaks the contradiction between clauses down into small steps, the empty clause last; steps
/// that it does without are left out. Where unit propagation is enough there is at most a step for
/// each atom. Nothing where the clauses do not contradict each other or too many conflicts were
/// met. Source: clause learning as in Marques-Silva and Sakallah 1999; proofs as in Goldberg and
/// Novikov 2003.
std::optional<std::vector<ChainStep>> UnitChain(const std::vector<PropositionalClause>& premises,
                                                const ChainLimits& limits = {});

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_UNIT_CHAIN_H_
