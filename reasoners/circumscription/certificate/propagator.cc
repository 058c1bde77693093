// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/certificate/propagator.h"

#include <algorithm>

namespace latchwork::circumscription {

Propagator::Propagator(const CompiledTheory& theory)
    : theory_(theory),
      middle_(theory.atom_count()),
      values_(2 * theory.atom_count() + 1, 0),
      open_(theory.clause_count()),
      trail_(theory.atom_count()) {
  for (std::size_t i = 0; i < theory.clause_count(); ++i) {
    const std::span<const Literal> clause = theory.clause(i);
    for (const Literal literal : clause) open_[i].sum ^= literal;
    open_[i].count = static_cast<std::uint32_t>(clause.size());
    refuted_ = refuted_ || clause.empty() || (clause.size() == 1 && !Assign(clause[0]));
  }
  refuted_ = refuted_ || !Propagate();
  root_ = size_;
  root_values_ = values_;
  root_open_ = open_;
}

void Propagator::Reset() {
  std::copy(root_values_.begin(), root_values_.end(), values_.begin());
  std::copy(root_open_.begin(), root_open_.end(), open_.begin());
  size_ = root_;
  next_ = root_;
}

bool Propagator::Propagate() {
  if (refuted_) return false;
  while (next_ < size_) {
    const Literal falsified = -trail_[next_++];
    for (const std::uint32_t clause : theory_.Occurrences(falsified)) {
      Open& open = open_[clause];
      open.sum ^= falsified;
      if (--open.count == 1 && !Assign(open.sum)) return false;
    }
  }
  return true;
}

}  // namespace latchwork::circumscription
