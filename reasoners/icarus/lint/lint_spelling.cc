// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>
#include <vector>

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
