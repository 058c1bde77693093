// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PROGRAM_H_
#define LATCHWORK_PTTP_PROGRAM_H_

#include <cstdint>
#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "reasoners/pttp/terms/arena.h"
#include "reasoners/pttp/terms/functors.h"
#include "reasoners/pttp/terms/word.h"
#include "reasoners/pttp/theory/predicates.h"

namespace latchwork::pttp {

inline constexpr std::uint32_t kNoClause = 0xffffffffU;

/// A literal of a compiled clause. As a subgoal it is to be proved as it stands.
struct CompiledLiteral {
  PredicateId predicate = 0;
  bool positive = true;
  std::uint32_t arity = 0;
  const Word* arguments = nullptr;
  std::uint64_t arithmetic =
      0;  ///< A bit for each of the first 64 arguments with an interpreted function in it.
  std::uint64_t needs_ground =
      0;  ///< Arguments that must be ground before the literal can be decided.
};

/// One way to use a clause: the head is proved when the body is. Without a head: a clause to start
/// a refutation from.
struct Contrapositive {
  CompiledLiteral head;
  bool has_head = false;
  bool linear = true;  ///< No variable occurs twice in the head.
  Word first_key = 0;  ///< What the first argument must be: a constant or a header; 0: anything.
  std::uint32_t slots = 0;           ///< Number of variables.
  std::uint32_t clause = kNoClause;  ///< Index into Program::clauses().
  std::uint32_t literal = 0;         ///< Which literal of it is the head.
  std::uint64_t eager = 0;  ///< Body literals that are better decided first when they can be.
  std::vector<CompiledLiteral> body;
};

/// A compiled body: immutable once made.
class Program {
 public:
  const std::vector<logic::Clause>& clauses() const { return clauses_; }
  /// By signed predicate of the head, in clause order, units first.
  std::span<const Contrapositive> rules(std::uint32_t signed_predicate) const {
    if (signed_predicate >= rules_.size()) return {};
    return rules_[signed_predicate];
  }
  std::size_t signed_predicates() const { return rules_.size(); }
  /// Clauses to start a refutation from: those of the negated conjecture, then all others without a
  /// positive literal.
  const std::vector<Contrapositive>& conjectures() const { return conjectures_; }
  const std::vector<Contrapositive>& negatives() const { return negatives_; }
  /// Whether the denial of anything can be concluded.
  bool HasNegativeHeads() const {
    for (std::size_t i = 0; i < rules_.size(); i += 2) {
      if (!rules_[i].empty()) return true;
    }
    return false;
  }
  bool has_arithmetic() const { return has_arithmetic_; }

 private:
  friend class Compiler;
  std::vector<logic::Clause> clauses_;
  std::vector<std::vector<Contrapositive>> rules_;
  std::vector<Contrapositive> conjectures_;
  std::vector<Contrapositive> negatives_;
  bool has_arithmetic_ = false;
  Arena terms_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PROGRAM_H_
