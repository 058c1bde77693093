// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "reasoners/icarus/language/signature.h"
#include "reasoners/icarus/language/walk.h"
#include "reasoners/icarus/lint/lint.h"

namespace latchwork::icarus {

namespace {

/// Compares the spellings of one kind of name with that at its first place.
class Spellings {
 public:
  Spellings(const SourceTree& tree, Reporter& reporter) : tree_(tree), reporter_(reporter) {}

  void Meet(FormId form) {
    const auto [known, is_new] = first_.emplace(tree_.Folded(form), form);
    if (is_new || reported_.contains(known->first)) return;
    if (tree_.Text(form) == tree_.Text(known->second)) return;
    reported_.emplace(known->first, form);
    reporter_.Add(Code::kSpelling, form,
                  "'" + std::string(tree_.Text(form)) + "' is spelt '" +
                      std::string(tree_.Text(known->second)) + "' elsewhere",
                  "the two are the same name; spell them alike");
    reporter_.Note(known->second, "the other spelling");
  }

 private:
  const SourceTree& tree_;
  Reporter& reporter_;
  std::map<std::string, FormId> first_;
  std::map<std::string, FormId> reported_;
};

/// Compares the spellings of what facts begin with, and of the symbols within.
class FactSpellings {
 public:
  FactSpellings(const SourceTree& tree, Reporter& reporter)
      : heads_(tree, reporter), symbols_(tree, reporter) {}

  /// A fact, or a pattern of facts.
  void MeetFact(std::span<const Term> items) {
    for (std::size_t i = 0; i < items.size(); ++i) Meet(items[i], i == 0);
  }

  void MeetClause(const Clause& clause) {
    if (clause.kind == ClauseKind::kMatch) return MeetFact(clause.terms);
    for (const Term& term : clause.terms) Meet(term, false);
  }

 private:
  void Meet(const Term& term, bool is_head) {
    if (term.kind == TermKind::kSymbol && term.form != kNoForm) {
      (is_head ? heads_ : symbols_).Meet(term.form);
    }
    const Signature* const builtin =
        term.kind == TermKind::kCall ? FindBuiltin(term.text) : nullptr;
    for (const Term& item : term.items) {
      if (builtin != nullptr && builtin->changes_memory) {
        MeetFact(item.items);
      } else {
        Meet(item, false);
      }
    }
  }

  Spellings heads_;
  Spellings symbols_;
};

void LintFactSpelling(const Program& program, Reporter& reporter) {
  FactSpellings spellings(program.source, reporter);
  for (const Term& fact : program.facts) spellings.MeetFact(fact.items);
  const auto meet = [&](const Skill& skill) {
    WalkClauses(skill, [&](const Clause& clause, Slot) { spellings.MeetClause(clause); });
  };
  WalkNameless(program, meet);
  for (const Skill& skill : program.skills) meet(skill);
}

}  // namespace

void LintSpelling(const Program& program, Reporter& reporter) {
  const SourceTree& tree = program.source;
  Spellings skills(tree, reporter);
  Spellings constants(tree, reporter);
  Spellings functions(tree, reporter);
  for (const Skill& skill : program.skills) skills.Meet(skill.name_form);
  for (const Constant& constant : program.constants) {
    if (constant.form != kNoForm) constants.Meet(constant.form);
  }
  WalkNameless(program, [&](const Skill& nameless) {
    WalkClauses(nameless, [&](const Clause& clause, Slot) {
      if (clause.kind == ClauseKind::kSkill) skills.Meet(tree.at(clause.form).first_child);
    });
  });
  LintFactSpelling(program, reporter);
  for (const Skill& skill : program.skills) {
    Spellings variables(tree, reporter);
    for (const FormId form : skill.variable_forms) variables.Meet(form);
    WalkClauses(skill, [&](const Clause& clause, Slot) {
      if (clause.kind == ClauseKind::kSkill) skills.Meet(tree.at(clause.form).first_child);
    });
    WalkTerms(skill, [&](const Term& term, Slot) {
      if (term.kind == TermKind::kVariable) variables.Meet(term.form);
      if (term.kind == TermKind::kConstant) constants.Meet(term.form);
      if (term.kind == TermKind::kCall) functions.Meet(tree.at(term.form).first_child);
    });
  }
}

}  // namespace latchwork::icarus
