// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PROPAGATION_H_
#define LATCHWORK_PTTP_PROPAGATION_H_

#include <cstddef>
#include <deque>
#include <limits>
#include <vector>

#include "reasoners/pttp/proofs/unit_chain.h"

namespace latchwork::pttp {

inline PropositionalLiteral Negated(PropositionalLiteral literal) { return literal ^ 1U; }
inline std::size_t AtomOf(PropositionalLiteral literal) { return literal / 2; }

/// Clauses and a trail of literals that are true: decided ones, each of which begins a level, and
/// those that follow by unit propagation, two literals of each clause being watched.
class Propagation {
 public:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  /// The number of the next clause; it takes part once it is watched. Its literals differ.
  std::size_t Add(PropositionalClause clause);
  /// A new clause, or one whose first two literals are the last ones to become false. Gives it back
  /// where it is false.
  std::size_t Watch(std::size_t index);
  /// Gives the clause that is false, if one is.
  std::size_t Propagate();
  /// Makes the first open atom false, on a level of its own; not where every atom has a value.
  bool Decide();
  void UndoTo(std::size_t level);

  bool IsTrue(PropositionalLiteral literal) const;
  bool IsFalse(PropositionalLiteral literal) const { return IsTrue(Negated(literal)); }
  std::size_t level() const { return marks_.size(); }
  std::size_t LevelOf(std::size_t atom) const { return atoms_[atom].level; }
  /// The clause that made it true or false.
  std::size_t ReasonOf(std::size_t atom) const { return atoms_[atom].reason; }
  const PropositionalClause& clause(std::size_t index) const { return clauses_[index]; }
  const std::vector<PropositionalLiteral>& trail() const { return trail_; }
  std::size_t level_begin() const { return marks_.empty() ? 0 : marks_.back(); }
  std::size_t atoms() const { return atoms_.size(); }

 private:
  struct AtomState {
    bool is_set = false;
    bool value = false;
    std::size_t level = 0;
    std::size_t reason = kNone;
  };

  void Set(PropositionalLiteral literal, std::size_t reason);
  /// Sees to the clauses that watch a literal that became false.
  std::size_t Visit(PropositionalLiteral literal);
  bool MovesWatch(PropositionalClause& clause, PropositionalLiteral literal, std::size_t index);

  std::deque<PropositionalClause> clauses_;        ///< References to them stay valid.
  std::vector<std::vector<std::size_t>> watches_;  ///< By literal.
  std::vector<AtomState> atoms_;
  std::vector<PropositionalLiteral> trail_;
  std::vector<std::size_t> marks_;  ///< By level, from 1: where it begins on the trail.
  std::size_t next_ = 0;            ///< On the trail: not yet propagated.
  std::size_t first_open_ = 0;      ///< All atoms before it are set.
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PROPAGATION_H_
