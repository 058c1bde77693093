// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SWIPL_RULE_WRITER_H_
#define LATCHWORK_SWIPL_RULE_WRITER_H_

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/sdk/reasoner.h"
#include "reasoners/contrapositives/signed_graph.h"
#include "reasoners/swipl/body_writer.h"
#include "reasoners/swipl/names.h"
#include "reasoners/swipl/vocabulary.h"

namespace latchwork::swipl {

/// A body in Prolog.
struct Rendering {
  std::string program;                                    ///< Clauses without directives.
  std::map<std::size_t, std::vector<logic::Fact>> facts;  ///< By number of their predicate.
  std::vector<std::string> denials;  ///< Names of the clauses without a positive literal.
  /// By goal: the name of the Prolog predicate with its clauses, and whose they are, in order.
  struct Clauses {
    std::string name;
    std::vector<std::string> sources;
  };
  std::map<Signed, Clauses> clauses;
};

/// Renders clauses as Stickel's PTTP does (1988): each contrapositive a Prolog clause, goals with
/// their ancestors where a complement may follow, and a depth where there is recursion. Horn parts
/// remember what failed instead of their ancestors. Unification is sound by a flag of SWI-Prolog.
class RuleWriter {
 public:
  RuleWriter(const sdk::Body& body, const std::vector<logic::Clause>& clauses, Names& names,
             logic::SymbolTable& symbols, bool unique_names);

  Rendering Write();
  /// A conjunction to be asked from outside, with `D` for the depth.
  std::string Query(const std::vector<logic::Literal>& goals);

 private:
  /// A contrapositive.
  struct Rule {
    Signed head = 0;
    logic::Atom pattern;
    std::vector<logic::Literal> body;
    std::string source;
  };
  /// How goals of a predicate are looked at before its clauses are.
  enum class Wrap { kNone, kTable, kMemo, kAncestors };

  static std::vector<Rule> RulesOf(const std::vector<logic::Clause>& clauses, Names& names,
                                   Vocabulary& vocabulary,
                                   std::map<std::size_t, std::vector<logic::Fact>>& facts);
  SignedGraph MakeGraph(const std::vector<logic::Clause>& clauses);
  std::set<Signed> FindTabled();
  Wrap WrapOf(Signed key) const;
  void WritePredicate(Signed key);
  void WriteWrapper(Signed key, Wrap wrap);
  void WriteClause(Signed key, std::string_view arguments, std::string_view body,
                   std::string source);
  void WriteRule(const Rule& rule, Wrap wrap);
  void WriteCut(Signed key, Wrap wrap);
  void WriteTable(Signed key);
  void WriteEquality(Signed key);
  void WriteStarts();
  /// `n3`, and `n3s` where a wrapper has that name.
  std::string NameOfClauses(Signed key) const;
  std::string Blanks(Signed key) const;

  const sdk::Body& body_;
  const std::vector<logic::Clause>& clauses_;
  Names& names_;
  Vocabulary vocabulary_;
  std::map<std::size_t, std::vector<logic::Fact>> facts_;
  std::vector<Rule> rules_;
  SignedGraph graph_;
  BodyWriter writer_;
  std::set<Signed> tabled_;  ///< Recursive, and make no terms.
  bool unique_names_;
  Rendering rendering_;
};

}  // namespace latchwork::swipl

#endif  // LATCHWORK_SWIPL_RULE_WRITER_H_
