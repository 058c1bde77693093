// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/lint/first_asked.h"

#include <vector>

namespace latchwork::icarus {

const Clause* FirstAsked(const Skill& skill) {
  if (skill.type == SkillType::kSequence) {
    const std::vector<Clause>* steps = skill.slot(Slot::kSequence);
    return steps == nullptr || steps->empty() ? nullptr : &steps->front();
  }
  if (skill.type != SkillType::kPlan) return nullptr;
  for (const Slot slot : {Slot::kObjective, Slot::kRequires, Slot::kMeans}) {
    const std::vector<Clause>* clauses = skill.slot(slot);
    if (clauses != nullptr && !clauses->empty()) return &clauses->front();
    if (slot == Slot::kObjective && clauses != nullptr) return nullptr;
  }
  return nullptr;
}

std::uint32_t FirstCalled(const Skill& skill) {
  if (!skill.is_whole) return kNoSkill;
  const Clause* clause = FirstAsked(skill);
  while (clause != nullptr && !clause->inner.empty()) clause = &clause->inner.front();
  return clause != nullptr && clause->kind == ClauseKind::kSkill ? clause->skill : kNoSkill;
}

}  // namespace latchwork::icarus
