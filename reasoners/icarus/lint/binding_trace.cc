// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/lint/binding_trace.h"

#include <algorithm>
#include <cstddef>

#include "reasoners/icarus/language/walk.h"

namespace latchwork::icarus {

namespace {

void MarkSurely(const Term& term, Bindings& bindings) {
  WalkTerm(term, [&](const Term& part) {
    if (part.kind != TermKind::kVariable) return;
    bindings.surely[part.index] = true;
    bindings.may[part.index] = true;
  });
}

void MarkMay(const Term& term, Bindings& bindings) {
  WalkTerm(term, [&](const Term& part) {
    if (part.kind == TermKind::kVariable) bindings.may[part.index] = true;
  });
}

bool IsGround(const Term& term, const Bindings& bindings) {
  bool ground = true;
  WalkTerm(term, [&](const Term& part) {
    ground = ground && part.kind != TermKind::kAnonymous &&
             (part.kind != TermKind::kVariable || bindings.surely[part.index]);
  });
  return ground;
}

/// Two variables of which neither is bound stay so. Of lists that are bound in part, all is taken
/// to be bound: better no finding than a wrong one.
void Unify(const Term& left, const Term& right, Bindings& bindings) {
  const auto is_open = [&](const Term& term) {
    return term.kind == TermKind::kAnonymous ||
           (term.kind == TermKind::kVariable && !bindings.surely[term.index]);
  };
  if (right.kind != TermKind::kCall && is_open(left) && is_open(right)) {
    const bool may = (left.kind == TermKind::kVariable && bindings.may[left.index]) ||
                     (right.kind == TermKind::kVariable && bindings.may[right.index]);
    if (may) {
      MarkMay(left, bindings);
      MarkMay(right, bindings);
    }
    return;
  }
  MarkSurely(left, bindings);
  if (right.kind != TermKind::kCall) MarkSurely(right, bindings);
}

void AddWay(const Bindings& way, std::size_t parameters, Exit& exit) {
  if (way.dead) return;
  for (std::size_t i = 0; i < parameters; ++i) {
    exit.surely[i] = way.surely[i] && (!exit.succeeds || exit.surely[i]);
    exit.may[i] = exit.may[i] || way.may[i];
  }
  exit.succeeds = true;
}

}  // namespace

Exit BindingTrace::Follow(const Skill& skill, const Bits& bound_parameters) {
  if (!skill.is_whole) return {true, Bits(skill.parameters, true), Bits(skill.parameters, true)};
  Exit exit{false, Bits(skill.parameters, true), Bits(skill.parameters, false)};
  Bindings entry{bound_parameters, {}, false};
  entry.surely.resize(skill.variables.size(), false);
  entry.may = entry.surely;
  missed_.assign(skill.parameters, false);
  for (const Slot slot : {Slot::kObjective, Slot::kSequence, Slot::kSensor}) {
    if (skill.slot(slot) == nullptr) continue;
    AddWay(Conjunction(skill, slot, entry), skill.parameters, exit);
  }
  Conjunction(skill, Slot::kAction, entry);
  const Bindings required = Conjunction(skill, Slot::kRequires, std::move(entry));
  const std::vector<Clause>* const means = skill.slot(Slot::kMeans);
  if (means == nullptr) return exit;
  for (const Clause& clause : *means) {
    Bindings way = required;
    Forgive(way);
    Ask(clause, way);
    AddWay(way, skill.parameters, exit);
  }
  return exit;
}

Bindings BindingTrace::Conjunction(const Skill& skill, Slot slot, Bindings bindings) {
  const std::vector<Clause>* const clauses = skill.slot(slot);
  if (clauses == nullptr) return bindings;
  Forgive(bindings);
  for (const Clause& clause : *clauses) Ask(clause, bindings);
  return bindings;
}

void BindingTrace::Forgive(Bindings& bindings) const {
  for (std::size_t i = 0; i < missed_.size(); ++i) {
    if (missed_[i]) bindings.surely[i] = true;
  }
}

void BindingTrace::Ask(const Clause& clause, Bindings& bindings) {
  for (const Term& term : clause.terms) {
    if (term.kind == TermKind::kCall) RequireCall(term, bindings);
  }
  switch (clause.kind) {
    case ClauseKind::kBind:
      Unify(clause.terms[0], clause.terms[1], bindings);
      break;
    case ClauseKind::kMatch:
      for (const Term& term : clause.terms) MarkSurely(term, bindings);
      break;
    case ClauseKind::kSkill:
      AskSkill(clause, bindings);
      break;
    default:
      break;
  }
  for (const Clause& inner : clause.inner) {
    Bindings within = bindings;
    Ask(inner, within);
  }
}

void BindingTrace::AskSkill(const Clause& clause, Bindings& bindings) {
  const Skill& callee = program_.skills[clause.skill];
  const bool acts = callee.type == SkillType::kAction;
  const bool needs_all = acts || callee.type == SkillType::kSequence;
  const std::size_t given = std::min(clause.terms.size(), callee.parameters);
  if (needs_all) {
    const Need need{acts ? Code::kUnboundAct : Code::kUnboundSequence,
                    (acts ? "the act '" : "the sequence '") + callee.spelling + "'"};
    for (const Term& term : clause.terms) Require(term, need, bindings);
  }
  Mode mode{clause.skill, Bits(callee.parameters, needs_all)};
  for (std::size_t i = 0; i < given; ++i) {
    mode.bound[i] = needs_all || IsGround(clause.terms[i], bindings);
  }
  const Exit exit = listener_.Call(std::move(mode), clause);
  bindings.dead = bindings.dead || !exit.succeeds;
  for (std::size_t i = 0; i < given; ++i) {
    if (exit.surely[i]) MarkSurely(clause.terms[i], bindings);
    if (exit.may[i]) MarkMay(clause.terms[i], bindings);
  }
}

void BindingTrace::Require(const Term& term, const Need& need, Bindings& bindings) {
  WalkTerm(term, [&](const Term& part) {
    const bool variable = part.kind == TermKind::kVariable;
    if (!(variable && !bindings.surely[part.index]) && part.kind != TermKind::kAnonymous) return;
    listener_.Missing(part, need, bindings);
    if (!variable) return;
    MarkSurely(part, bindings);
    if (part.index < missed_.size()) missed_[part.index] = true;
  });
}

/// What {forget} and {update} look for is a pattern: there variables may be unbound.
void BindingTrace::RequireCall(const Term& call, Bindings& bindings) {
  const bool pattern_first = call.text == "forget" || call.text == "update";
  const Need need{Code::kUnboundCall, "{" + call.text + "}"};
  for (std::size_t i = pattern_first ? 1 : 0; i < call.items.size(); ++i) {
    Require(call.items[i], need, bindings);
  }
}

}  // namespace latchwork::icarus
