// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/lint/sure_outcomes.h"

#include <algorithm>
#include <cstddef>

#include "reasoners/icarus/language/walk.h"

namespace latchwork::icarus {

/// A fixpoint: what is known of a skill is only ever made more exact, once or twice.
SureOutcomes::SureOutcomes(const Program& program)
    : outcomes_(program.skills.size(), Outcome::kUnknown) {
  std::vector<std::vector<std::size_t>> callers(program.skills.size());
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < program.skills.size(); ++i) {
    open.push_back(i);
    WalkClauses(program.skills[i], [&](const Clause& clause, Slot) {
      if (clause.kind == ClauseKind::kSkill) callers[clause.skill].push_back(i);
    });
  }
  while (!open.empty()) {
    const std::size_t index = open.back();
    open.pop_back();
    const Outcome found = OfSkill(program.skills[index]);
    const bool is_exact = outcomes_[index] > Outcome::kNeverFalse;
    if (is_exact || found <= outcomes_[index]) continue;
    outcomes_[index] = found;
    open.insert(open.end(), callers[index].begin(), callers[index].end());
  }
}

bool SureOutcomes::ObjectiveIsNeverFalse(const Skill& skill) const {
  const std::vector<Clause>* const objective = skill.slot(Slot::kObjective);
  return skill.is_whole && objective != nullptr && !objective->empty() &&
         OfConjunction(*objective) != Outcome::kUnknown;
}

/// What acts within *not* acts there, too.
SureOutcomes::Outcome SureOutcomes::Of(const Clause& clause) const {
  if (clause.kind == ClauseKind::kSkill) return outcomes_[clause.skill];
  if (clause.kind != ClauseKind::kNot || clause.inner.empty()) return Outcome::kUnknown;
  return Of(clause.inner.front()) == Outcome::kActs ? Outcome::kActs : Outcome::kUnknown;
}

/// An act of one clause is an outcome of all, though the later clauses are not asked then.
SureOutcomes::Outcome SureOutcomes::OfConjunction(const std::vector<Clause>& clauses) const {
  Outcome outcome = Outcome::kTrue;
  for (const Clause& clause : clauses) {
    const Outcome next = Of(clause);
    if (next == Outcome::kUnknown) return Outcome::kUnknown;
    if (next == Outcome::kActs) return outcome == Outcome::kTrue ? next : Outcome::kNeverFalse;
    if (next == Outcome::kNeverFalse) outcome = next;
  }
  return outcome;
}

/// A sequence may be at any of its steps.
SureOutcomes::Outcome SureOutcomes::OfSteps(const std::vector<Clause>& steps) const {
  Outcome outcome = Outcome::kTrue;
  for (const Clause& step : steps) {
    const Outcome next = Of(step);
    if (next == Outcome::kUnknown) return Outcome::kUnknown;
    if (next != Outcome::kTrue) outcome = Outcome::kNeverFalse;
  }
  return outcome;
}

SureOutcomes::Outcome SureOutcomes::OfMeans(const std::vector<Clause>& means) const {
  Outcome outcome = Outcome::kUnknown;
  for (const Clause& clause : means) outcome = std::max(outcome, Of(clause));
  return outcome;
}

SureOutcomes::Outcome SureOutcomes::OfPlan(const Skill& skill) const {
  const std::vector<Clause>* const objective = skill.slot(Slot::kObjective);
  const std::vector<Clause>* const requires_slot = skill.slot(Slot::kRequires);
  const std::vector<Clause>* const means = skill.slot(Slot::kMeans);
  if (objective != nullptr) {
    const Outcome outcome = OfConjunction(*objective);
    if (outcome != Outcome::kUnknown) return outcome;
  }
  const Outcome required =
      requires_slot == nullptr ? Outcome::kTrue : OfConjunction(*requires_slot);
  Outcome rest = required;
  if (required != Outcome::kUnknown && required != Outcome::kActs) {
    rest = means == nullptr ? Outcome::kUnknown : OfMeans(*means);
    if (required == Outcome::kNeverFalse) rest = std::min(rest, required);
  }
  return objective == nullptr ? rest : std::min(rest, Outcome::kNeverFalse);
}

SureOutcomes::Outcome SureOutcomes::OfSkill(const Skill& skill) const {
  if (!skill.is_whole) return Outcome::kUnknown;
  switch (skill.type) {
    case SkillType::kPlan:
      return OfPlan(skill);
    case SkillType::kSequence:
      return OfSteps(*skill.slot(Slot::kSequence));
    case SkillType::kAction:
      return Outcome::kActs;
    case SkillType::kSensor:
      return Outcome::kUnknown;
  }
  return Outcome::kUnknown;
}

}  // namespace latchwork::icarus
