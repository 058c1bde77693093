// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SWIPL_BODY_WRITER_H_
#define LATCHWORK_SWIPL_BODY_WRITER_H_

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/logic/clause.h"
#include "reasoners/contrapositives/signed_graph.h"
#include "reasoners/swipl/names.h"
#include "reasoners/swipl/vocabulary.h"

namespace latchwork::swipl {

using contrapositives::ComplementOf;
using contrapositives::Signed;
using contrapositives::SignedGraph;
using contrapositives::SignedOf;
using Variables = std::set<logic::Variable>;
void AddVariables(const logic::Term& term, Variables& variables);

/// Writes conjunctions of goals: computed ones as soon as their variables are bound, the others in
/// the order of the clause, but for facts with a known argument, which come before rules. What is
/// not ground when its turn comes waits.
class BodyWriter {
 public:
  BodyWriter(Names& names, Vocabulary& vocabulary, const SignedGraph& graph, bool unique_names)
      : names_(names), vocabulary_(vocabulary), graph_(graph), unique_names_(unique_names) {}

  /// Which predicates have tables; in their own clauses, where `more` is empty, they are called
  /// without a detour.
  void SetTabled(std::set<Signed> tabled) { tabled_ = std::move(tabled); }
  /// Whether a goal never waits, assumes nothing and takes no terms apart.
  bool IsPlain(const logic::Literal& goal);
  /// `more`: what calls of predicates get besides their arguments, as in "D,Up".
  std::string Write(std::vector<logic::Literal> goals, Variables bound, std::string_view more);

 private:
  std::size_t Choose(const std::vector<logic::Literal>& goals, const Variables& bound);
  /// Variables that must be ground before the goal can be decided.
  Variables Needs(const logic::Literal& goal);
  bool IsComputed(const logic::Literal& goal);
  bool IsExtensional(const logic::Literal& goal, const Variables& bound);
  bool HasRules(const logic::Literal& goal) const;
  void WriteGoal(const logic::Literal& goal, std::string_view more, std::string& text);
  std::string Core(const logic::Literal& goal, std::string_view more);
  /// Prolog that computes the arithmetic in a term, and what then stands for the term.
  std::string Evaluate(const logic::Term& term, std::string& before);
  std::string CallOf(const logic::Literal& goal, const std::vector<std::string>& arguments,
                     std::string_view more);
  std::string CallAttachment(const logic::Literal& goal, const std::vector<std::string>& arguments);

  Names& names_;
  Vocabulary& vocabulary_;
  const SignedGraph& graph_;
  bool unique_names_;
  std::set<Signed> tabled_;
  std::size_t values_ = 0;  ///< Numbers the results of arithmetic.
};

}  // namespace latchwork::swipl

#endif  // LATCHWORK_SWIPL_BODY_WRITER_H_
