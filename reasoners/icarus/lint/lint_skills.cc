// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/walk.h"
#include "reasoners/icarus/lint/first_asked.h"
#include "reasoners/icarus/lint/lint.h"
#include "reasoners/icarus/lint/program_tops.h"
#include "reasoners/icarus/lint/sure_outcomes.h"

namespace latchwork::icarus {

namespace {

void LintReach(const Program& program, const CheckOptions& options, Reporter& reporter) {
  std::vector<std::uint32_t> open = TopsOf(program, options);
  for (const Skill& never : program.nevers) {
    WalkClauses(never, [&](const Clause& clause, Slot) {
      if (clause.kind == ClauseKind::kSkill) open.push_back(clause.skill);
    });
  }
  std::vector<bool> reached(program.skills.size(), false);
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    open.pop_back();
    if (index == kNoSkill || reached[index]) continue;
    reached[index] = true;
    WalkClauses(program.skills[index], [&](const Clause& clause, Slot) {
      if (clause.kind == ClauseKind::kSkill) open.push_back(clause.skill);
    });
  }
  for (std::size_t i = 0; i < program.skills.size(); ++i) {
    if (reached[i]) continue;
    reporter.Add(Code::kUnreachable, program.skills[i].name_form,
                 "the skill '" + program.skills[i].spelling + "' is never reached",
                 "call it, or take it out");
  }
}

bool IsEmpty(const std::vector<Clause>* clauses) { return clauses == nullptr || clauses->empty(); }

/// Each skill asks one other first, at most: a walk that meets its own track is a cycle.
void LintEndless(const Program& program, Reporter& reporter) {
  std::vector<std::size_t> track(program.skills.size(), 0);
  for (std::size_t i = 0; i < program.skills.size(); ++i) {
    auto at = static_cast<std::uint32_t>(i);
    while (at != kNoSkill && track[at] == 0) {
      track[at] = i + 1;
      at = FirstCalled(program.skills[at]);
    }
    if (at == kNoSkill || track[at] != i + 1) continue;
    reporter.Add(Code::kEndless, program.skills[at].name_form,
                 "the skill '" + program.skills[at].spelling + "' calls itself before all else",
                 "begin with an :objective or a condition that ends the recursion");
  }
}

/// Whether the skill offers an act whenever it is asked.
bool AlwaysActs(const Program& program, std::uint32_t index) {
  for (std::size_t steps = 0; steps < program.skills.size(); ++steps) {
    const Skill& skill = program.skills[index];
    if (!skill.is_whole) return false;
    if (skill.type == SkillType::kAction) return true;
    const bool unconditional = skill.type == SkillType::kPlan &&
                               skill.slot(Slot::kObjective) == nullptr &&
                               IsEmpty(skill.slot(Slot::kRequires));
    if (!unconditional) return false;
    index = FirstCalled(skill);
    if (index == kNoSkill || !FirstAsked(skill)->inner.empty()) return false;
  }
  return false;
}

void LintMeans(const Program& program, const Skill& skill, Reporter& reporter) {
  const std::vector<Clause>* means = skill.slot(Slot::kMeans);
  if (means == nullptr) return;
  for (std::size_t i = 0; i + 1 < means->size(); ++i) {
    const Clause& clause = (*means)[i];
    if (clause.kind != ClauseKind::kSkill || !AlwaysActs(program, clause.skill)) continue;
    reporter.Add(Code::kHidingMeans, clause.form,
                 "this act is always offered, so with acts = first those after it never are",
                 "put it last, or give it a condition");
    return;
  }
}

/// An objective with clauses that is never False leaves nothing to the rest of the plan.
void LintNeverFalse(const SureOutcomes& sure, const Skill& skill, Reporter& reporter) {
  const bool has_rest =
      skill.slot(Slot::kRequires) != nullptr || skill.slot(Slot::kMeans) != nullptr;
  if (!has_rest || !sure.ObjectiveIsNeverFalse(skill)) return;
  const Slot rest = skill.slot(Slot::kMeans) != nullptr ? Slot::kMeans : Slot::kRequires;
  reporter.Add(Code::kAlwaysTrue, skill.slot_forms[static_cast<std::size_t>(Slot::kObjective)],
               "this :objective is always True or acts, so '" + skill.spelling +
                   "' never comes to its " + std::string(KeywordOf(rest)),
               "let the :objective say what is to be True, and put acts into :means");
  reporter.Note(skill.slot_forms[static_cast<std::size_t>(rest)], "never asked for");
}

void LintObjective(const Program& program, const SureOutcomes& sure, const Skill& skill,
                   Reporter& reporter) {
  const std::vector<Clause>* objective = skill.slot(Slot::kObjective);
  if (objective == nullptr || !skill.is_whole) return;
  if (!objective->empty()) return LintNeverFalse(sure, skill, reporter);
  const FormId keyword = skill.slot_forms[static_cast<std::size_t>(Slot::kObjective)];
  if (program.source.at(program.source.at(keyword).next_sibling).first_child != kNoForm) return;
  reporter.Add(Code::kAlwaysTrue, keyword,
               "an empty :objective is True, so '" + skill.spelling + "' never acts",
               "take it out: without one the objective is False");
}

/// A call of an :action before which more is to come.
void LintActs(const Program& program, const Skill& skill, Slot slot, bool more_behind,
              Reporter& reporter) {
  const std::vector<Clause>* const clauses = skill.slot(slot);
  if (clauses == nullptr) return;
  for (std::size_t i = 0; i < clauses->size(); ++i) {
    const Clause& clause = (*clauses)[i];
    const bool acts = clause.kind == ClauseKind::kSkill &&
                      program.skills[clause.skill].type == SkillType::kAction;
    if (!acts || (i + 1 == clauses->size() && !more_behind)) continue;
    reporter.Add(
        Code::kActIsNotTrue, clause.form,
        "an act is never True, so what stands behind this call is never asked",
        "call a skill whose :objective tells when it is done, and whose :means is the act");
    reporter.Note(program.skills[clause.skill].name_form, "an :action");
    return;
  }
}

}  // namespace

void LintSkills(const Program& program, const CheckOptions& options, Reporter& reporter) {
  const SureOutcomes sure(program);
  for (std::uint32_t i = 0; i < program.skills.size(); ++i) {
    LintObjective(program, sure, program.skills[i], reporter);
    LintMeans(program, program.skills[i], reporter);
    const Skill& skill = program.skills[i];
    if (!sure.ObjectiveIsNeverFalse(skill)) {
      LintActs(program, skill, Slot::kObjective, false, reporter);
    }
    LintActs(program, skill, Slot::kRequires, !IsEmpty(skill.slot(Slot::kMeans)), reporter);
    LintActs(program, skill, Slot::kSequence, false, reporter);
  }
  LintEndless(program, reporter);
  LintRecursion(program, reporter);
  LintReach(program, options, reporter);
}

}  // namespace latchwork::icarus
