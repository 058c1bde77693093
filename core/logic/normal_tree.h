// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_NORMAL_TREE_H_
#define LATCHWORK_LOGIC_NORMAL_TREE_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/formula.h"

namespace latchwork::logic {

/// A formula on its way to clauses: negations stand at atoms only, nested conjunctions and
/// disjunctions are one, and equivalences are still whole. Nodes are numbers; nothing recurses.
struct NormalTree {
  enum class Kind : std::uint8_t {
    kTrue,
    kFalse,
    kLiteral,
    kAnd,
    kOr,
    kEquivalent,
    kForall,
    kExists,
  };
  using Id = std::uint32_t;

  struct Node {
    Kind kind = Kind::kTrue;
    bool positive = true;        ///< Literals only.
    const Atom* atom = nullptr;  ///< Literals only.
    std::vector<Id> children = {};
    std::vector<Variable> variables = {};  ///< Quantifiers only.
  };

  /// The formula, or its negation, with its free variables closed universally. Refers to the atoms
  /// of `formula`, which must stay alive.
  static NormalTree Of(const Formula& formula, bool positive);

  Id Add(Node node);
  Id AddLiteral(Atom atom, bool positive);
  /// The variables that occur below `id` and are not quantified there, in ascending order.
  std::vector<Variable> FreeVariables(Id id) const;
  /// `id` and everything below it, each node before its children.
  std::vector<Id> Below(Id id) const;

  std::vector<Node> nodes;
  Id root = 0;
  std::deque<Atom> own_atoms;  ///< Those that are not in the formula.
};

/// Appends the variables of an atom, as often as they occur.
void CollectVariables(const Atom& atom, std::vector<Variable>& variables);

/// Ascending, each once.
void SortUnique(std::vector<Variable>& variables);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_NORMAL_TREE_H_
