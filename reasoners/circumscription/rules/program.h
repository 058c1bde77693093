// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_PROGRAM_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_PROGRAM_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "latchwork/logic/arithmetic.h"
#include "latchwork/logic/clause.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/reasoner.h"
#include "reasoners/circumscription/rules/relations.h"
#include "reasoners/circumscription/rules/rule.h"
#include "reasoners/circumscription/rules/rule_compiler.h"
#include "reasoners/circumscription/rules/strata.h"

namespace latchwork::circumscription {

/// The clauses of a body as rules, stratum by stratum.
///
/// For a certificate each clause has at most one head: the literal that may vary or is minimized
/// last; minimized atoms besides it are defaults of its body. Clauses that have no such head are
/// constraints. For grounding every positive literal is a head.
class Program {
 public:
  enum class Purpose : std::uint8_t { kCertificate, kGrounding };

  Program(Purpose purpose, const sdk::Body& body, logic::SymbolTable& symbols);

  /// Replaces the rules. On diagnostics, each with the place of a clause and the reason, the
  /// clauses are no finite theory that can be grounded.
  logic::Diagnostics Compile(std::vector<logic::Clause> clauses);

  /// A rule with the head `answers`(its variables) for a conjunction; nothing: `problem` says why.
  std::optional<Rule> CompileQuery(std::span<const logic::Literal> query, std::size_t variables,
                                   std::size_t answers, std::string& problem);
  /// A relation of its own for the answers to a query.
  std::size_t AddAnswers(std::size_t variables);
  /// That `attachment` asks for `relation`, which Stratify heeds. False: that was known.
  bool AddQuestion(std::size_t attachment, std::size_t relation);
  /// Finds the strata anew.
  void Stratify();
  /// Whether an attachment depends on itself through what it asks for; its name, else "".
  std::string CircularAttachment() const;

  const std::vector<logic::Clause>& clauses() const { return clauses_; }
  const std::vector<Rule>& rules() const { return rules_; }
  const std::vector<Stratum>& strata() const { return strata_; }
  const std::vector<std::size_t>& constraints() const { return constraints_; }
  Relations& relations() { return relations_; }
  const Relations& relations() const { return relations_; }

 private:
  std::vector<UsedLiteral> UsesOf(const logic::Clause& clause) const;
  const logic::Literal* ChooseHead(std::span<const logic::Literal* const> positive) const;
  bool IsOrdinary(const logic::Literal& literal) const;
  int LevelOf(const logic::Literal& literal) const;
  bool AddRule(std::size_t clause, logic::Diagnostics& diagnostics);
  Dependencies FindDependencies() const;
  bool DemoteUnstratified();
  void Arrange();
  std::size_t LastStratumOf(const Rule& rule) const;
  void CheckGrowth(logic::Diagnostics& diagnostics) const;

  Purpose purpose_;
  logic::Arithmetic arithmetic_;
  logic::Symbol equality_;
  logic::SymbolTable& symbols_;
  Relations relations_;
  std::vector<logic::Clause> clauses_;
  std::vector<Rule> rules_;
  std::vector<bool> is_demoted_;  ///< By rule: its head is one more default.
  std::vector<Stratum> strata_;
  std::vector<std::size_t> constraints_;
  Dependencies questions_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_PROGRAM_H_
