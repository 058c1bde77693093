// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_RULE_COMPILER_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_RULE_COMPILER_H_

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "latchwork/logic/arithmetic.h"
#include "latchwork/logic/clause.h"
#include "reasoners/circumscription/rules/relations.h"
#include "reasoners/circumscription/rules/rule.h"

namespace latchwork::circumscription {

/// What a literal of a clause is for a rule.
enum class Use : std::uint8_t {
  kBody,    ///< Holds in the instances: a fact, arithmetic, an equation or an attachment.
  kAbsent,  ///< Is no fact: a default.
  kHead,
  kOpen,  ///< May hold or not.
};

struct UsedLiteral {
  const logic::Literal* literal = nullptr;
  Use use = Use::kBody;
};

/// Lays literals out so that each step finds bound what it needs.
class RuleCompiler {
 public:
  RuleCompiler(Relations& relations, const logic::Arithmetic& arithmetic, logic::Symbol equality)
      : relations_(relations), arithmetic_(arithmetic), equality_(equality) {}

  /// Nothing: `problem` says what cannot be laid out. `variables`: names; variables 0 .. size-1.
  std::optional<Rule> Compile(std::span<const UsedLiteral> literals,
                              std::span<const std::string> variables, std::string& problem);

 private:
  struct Pending {
    Step::Kind kind = Step::Kind::kJoin;
    bool negated = false;
    std::size_t relation = kNoIndex;
    std::vector<logic::Term> terms;
    logic::Arithmetic::Predicate test{};
    std::size_t literal = kNoIndex;
  };

  void AddBody(const UsedLiteral& used, std::size_t index);
  void AddEquation(const logic::Literal& literal, std::size_t index);
  bool AddRest(const UsedLiteral& used, std::size_t index, std::string& problem);
  logic::Term Flatten(const logic::Term& term);
  bool Order(std::string& problem);
  bool IsReady(const Pending& pending) const;
  std::size_t Merit(const Pending& pending) const;
  void Emit(const Pending& pending);
  void EmitEquation(const Pending& pending, Step& step);
  void ChooseLookup(const Pending& pending, Step& step);
  bool IsBound(const logic::Term& term) const;
  bool IsComputed(const logic::Term& term) const;
  std::string Unbound(const logic::Term& term) const;
  Pattern Match(const logic::Term& term);
  Pattern Build(const logic::Term& term) const;

  Relations& relations_;
  const logic::Arithmetic& arithmetic_;
  logic::Symbol equality_;
  std::span<const std::string> names_;
  std::vector<bool> bound_;  ///< By variable.
  std::vector<Pending> pending_;
  Rule rule_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_RULE_COMPILER_H_
