// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/clauses.h"

#include <algorithm>

namespace latchwork::pttp::saturation {

std::string_view Name(Rule rule) {
  switch (rule) {
    case Rule::kInput:
      return "input";
    case Rule::kResolution:
      return "resolution";
    case Rule::kSuperposition:
      return "superposition";
    case Rule::kFactoring:
      return "factoring";
    case Rule::kEqualityFactoring:
      return "equality_factoring";
    case Rule::kEqualityResolution:
      return "equality_resolution";
    case Rule::kSimplification:
      return "simplification";
  }
  return "";
}

void Draft::AddParent(ClauseId parent) {
  if (std::ranges::find(parents, parent) == parents.end()) parents.push_back(parent);
}

ClauseId Clauses::Add(const Draft& draft, bool goal) {
  ClauseRecord record;
  record.first_literal = static_cast<std::uint32_t>(literals_.size());
  record.literal_count = static_cast<std::uint32_t>(draft.literals.size());
  record.first_parent = static_cast<std::uint32_t>(parents_.size());
  record.parent_count = static_cast<std::uint32_t>(draft.parents.size());
  record.rule = draft.rule;
  record.goal = goal || std::ranges::any_of(draft.parents,
                                            [&](ClauseId parent) { return records_[parent].goal; });
  for (const Literal& literal : draft.literals) {
    record.size += terms_.size(literal.left);
    record.goal_weight += terms_.goal_weight(literal.left);
    if (!literal.is_equation()) continue;
    record.size += terms_.size(literal.right);
    record.goal_weight += terms_.goal_weight(literal.right);
  }
  literals_.insert(literals_.end(), draft.literals.begin(), draft.literals.end());
  parents_.insert(parents_.end(), draft.parents.begin(), draft.parents.end());
  records_.push_back(record);
  return static_cast<ClauseId>(records_.size() - 1);
}

std::size_t Clauses::bytes() const {
  return records_.capacity() * sizeof(ClauseRecord) + literals_.capacity() * sizeof(Literal) +
         parents_.capacity() * sizeof(ClauseId);
}

}  // namespace latchwork::pttp::saturation
