// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_CLAUSE_BUILDER_H_
#define LATCHWORK_ICARUS_CLAUSE_BUILDER_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

/// The names that clauses are resolved against.
struct Names {
  std::map<std::string, std::uint32_t, std::less<>> skills;
  std::map<std::string, std::uint32_t, std::less<>> constants;
};

/// Turns forms into terms and clauses, those of one skill after another.
class ClauseBuilder {
 public:
  ClauseBuilder(const SourceTree& tree, const Names& names, Reporter& reporter)
      : tree_(tree), names_(names), reporter_(reporter) {}

  /// `skill` takes the variables; null: variables and calls are errors (of `ground_code`).
  void Begin(Skill* skill, Code ground_code);

  std::optional<Term> MakeTerm(FormId form, bool calls_allowed);
  std::optional<Clause> MakeClause(FormId form, Slot slot);
  std::vector<Clause> MakeClauses(FormId list, Slot slot);
  /// The index of a variable in the skill, entered at its first use.
  std::uint32_t Enter(FormId variable);

 private:
  std::optional<Term> Variable(Term term);
  std::optional<Term> Constant(Term term);
  std::optional<Term> List(Term term, bool calls_allowed);
  std::optional<Term> Call(Term term);
  std::optional<Clause> InParentheses(FormId form, Slot slot);
  std::optional<Clause> Bind(Clause clause, const std::vector<FormId>& children);
  std::optional<Clause> Negation(Clause clause, const std::vector<FormId>& children, Slot slot);
  std::optional<Clause> Arguments(Clause clause, const std::vector<FormId>& children,
                                  std::size_t first);
  bool IsAllowed(FormId form, Slot slot);
  /// Of a symbol or constant, folded; empty for everything else.
  std::string AtomName(FormId form) const;

  const SourceTree& tree_;
  const Names& names_;
  Reporter& reporter_;
  Skill* skill_ = nullptr;
  std::map<std::string, std::uint32_t, std::less<>> variables_;  ///< Of `skill_`.
  Code ground_code_ = Code::kFact;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_CLAUSE_BUILDER_H_
