// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_CLAUSE_MAKER_H_
#define LATCHWORK_LOGIC_CLAUSE_MAKER_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/logic/clause_recorder.h"
#include "core/logic/miniscope.h"
#include "core/logic/normal_tree.h"
#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::logic {

/// A clause before its variables get their final numbers: indices into the maker's literals.
using LiteralIndices = std::vector<std::uint32_t>;

/// What all clauses of one call may cost together, in symbols written.
class WorkMeter {
 public:
  explicit WorkMeter(std::size_t limit) : left_(limit) {}
  void Spend(std::size_t amount) { left_ = amount > left_ ? 0 : left_ - amount; }
  bool is_spent() const { return left_ == 0; }

 private:
  std::size_t left_;
};

/// Turns the nodes of a tree into clauses: Skolemizes, distributes, and numbers variables densely.
class ClauseMaker {
 public:
  /// `free` may be null: Skolem functions then get all universal variables around them. `recorder`
  /// may be null.
  ClauseMaker(const NormalTree& tree, const FreeVariableTable* free,
              const std::vector<std::string>& variable_names, SymbolTable& symbols, WorkMeter& work,
              ClauseRecorder* recorder);

  /// An equivalence is the conjunction of two disjunctions, its halves.
  enum class Half : std::uint8_t { kNone, kFirst, kSecond };
  struct Item {
    NormalTree::Id id = 0;
    bool positive = true;
    Half half = Half::kNone;
  };
  /// Appends the clauses of the disjunction of the items, universally closed over `variables`;
  /// `pattern` gives them name, role and place.
  void Make(const std::vector<Item>& disjunction, const std::vector<Variable>& variables,
            const Clause& pattern, std::vector<Clause>& clauses);
  /// By fresh variable of the last call: the variable of the tree.
  const std::vector<Variable>& sources() const { return sources_; }

 private:
  struct Frame {
    Item item;
    bool is_disjunction = false;
    std::size_t first = 0;   ///< Of its clauses in `done_`.
    std::size_t middle = 0;  ///< Where the clauses of the last child begin.
    std::size_t scope = 0;   ///< Universal variables around it.
    std::size_t next = 0;
  };

  void Expand(const std::vector<Item>& disjunction);
  void Begin(const Item& item);
  bool IsDisjunction(const Item& item) const;
  Item ChildItem(const Frame& frame, std::size_t index) const;
  std::size_t ChildCount(const Frame& frame) const;
  void BindVariables(const Item& item);
  void Record(const Frame& frame);
  std::vector<Variable> FreshFrom(std::size_t scope, std::size_t count) const;
  Term FreshVariable(Variable source);
  Term SkolemTerm(NormalTree::Id quantifier);
  std::vector<Term> SkolemArguments(NormalTree::Id quantifier);
  void AddLiteral(const NormalTree::Node& node, bool positive);
  Atom Substitute(const Atom& atom);
  /// The clauses from `first` to `middle` and those from `middle` on become their disjunction.
  void Distribute(std::size_t first, std::size_t middle);

  /// Nothing for a tautology.
  std::optional<Clause> Finish(const LiteralIndices& indices, const Clause& pattern);
  bool IsTautology(const LiteralIndices& indices) const;
  LiteralIndices WithoutRepetition(const LiteralIndices& indices) const;
  Atom Renumber(const Atom& atom);
  std::vector<std::string> Names() const;

  const NormalTree& tree_;
  const FreeVariableTable* free_;
  const std::vector<std::string>& variable_names_;
  SymbolTable& symbols_;
  WorkMeter& work_;
  ClauseRecorder* recorder_;

  std::vector<std::optional<Term>> bindings_;  ///< By variable of the tree.
  std::vector<Variable> sources_;              ///< By fresh variable: the variable of the tree.
  std::vector<Term> scope_;                    ///< Universal variables around, outermost first.
  std::vector<Frame> open_;
  std::vector<LiteralIndices> done_;
  std::vector<Literal> literals_;
  std::vector<std::optional<Variable>> numbers_;  ///< By fresh variable, within one clause.
  std::vector<Variable> numbered_;                ///< Fresh variables that have a number.
};

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_CLAUSE_MAKER_H_
