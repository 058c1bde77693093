// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_WALK_H_
#define LATCHWORK_ICARUS_WALK_H_

#include <cstddef>

#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

/// Calls `visit(clause, slot)` for a clause and the one that it negates.
template <typename Visit>
void WalkClause(const Clause& clause, Slot slot, const Visit& visit) {
  visit(clause, slot);
  for (const Clause& inner : clause.inner) WalkClause(inner, slot, visit);
}

/// Calls `visit(clause, slot)` for every clause of a skill, in the order of slots.
template <typename Visit>
void WalkClauses(const Skill& skill, const Visit& visit) {
  for (std::size_t i = 0; i < kSlots; ++i) {
    const auto slot = static_cast<Slot>(i);
    if (skill.slot(slot) == nullptr) continue;
    for (const Clause& clause : *skill.slot(slot)) WalkClause(clause, slot, visit);
  }
}

/// Calls `visit(skill)` for the top and for what is never to be: skills without a name.
template <typename Visit>
void WalkNameless(const Program& program, const Visit& visit) {
  if (program.top) visit(*program.top);
  for (const Skill& never : program.nevers) visit(never);
}

/// Calls `visit(term)` for a term and all within it.
template <typename Visit>
void WalkTerm(const Term& term, const Visit& visit) {
  visit(term);
  for (const Term& item : term.items) WalkTerm(item, visit);
}

/// Calls `visit(term, slot)` for every term of a skill, however deep, but those of its :value.
template <typename Visit>
void WalkTerms(const Skill& skill, const Visit& visit) {
  WalkClauses(skill, [&](const Clause& clause, Slot slot) {
    for (const Term& term : clause.terms) {
      WalkTerm(term, [&](const Term& part) { visit(part, slot); });
    }
  });
}

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_WALK_H_
