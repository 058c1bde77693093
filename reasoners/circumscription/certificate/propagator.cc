// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/certificate/propagator.h"

#include <algorithm>
#include <utility>

namespace latchwork::circumscription {

Propagator::Propagator(const CompiledTheory& theory)
    : middle_(theory.atom_count()),
      values_(2 * theory.atom_count() + 1, 0),
      watches_(2 * theory.atom_count() + 1),
      trail_(theory.atom_count()) {
  for (std::size_t i = 0; i < theory.clause_count(); ++i) AddClause(theory.clause(i));
  refuted_ = !Propagate() || refuted_;
  root_ = size_;
  root_values_ = values_;
}

void Propagator::AddClause(std::span<const Literal> clause) {
  if (clause.empty()) {
    refuted_ = true;
  } else if (clause.size() == 1) {
    refuted_ = !Assign(clause[0]) || refuted_;
  } else if (clause.size() == 2) {
    watches_[Index(clause[0])].push_back({clause[1], kBinary, 2});
    watches_[Index(clause[1])].push_back({clause[0], kBinary, 2});
  } else {
    const auto start = static_cast<std::uint32_t>(literals_.size());
    const auto size = static_cast<std::uint32_t>(clause.size());
    literals_.insert(literals_.end(), clause.begin(), clause.end());
    watches_[Index(clause[0])].push_back({clause[1], start, size});
    watches_[Index(clause[1])].push_back({clause[0], start, size});
  }
}

void Propagator::Reset() {
  std::copy(root_values_.begin(), root_values_.end(), values_.begin());
  size_ = root_;
  next_ = root_;
}

bool Propagator::Propagate() {
  if (refuted_) return false;
  while (next_ < size_) {
    const Literal falsified = -trail_[next_++];
    if (!watches_[Index(falsified)].empty() && !Visit(falsified)) return false;
  }
  return true;
}

bool Propagator::Visit(Literal falsified) {
  std::vector<Watch>& watches = watches_[Index(falsified)];
  for (std::size_t i = 0; i < watches.size();) {
    const Watch watch = watches[i];
    if (Value(watch.other) > 0) {
      ++i;
    } else if (watch.start == kBinary) {
      if (!Assign(watch.other)) return false;
      ++i;
    } else if (MoveWatch(watch, falsified)) {
      watches[i] = watches.back();
      watches.pop_back();
    } else {
      const Literal first = literals_[watch.start];
      watches[i++].other = first;
      if (!Assign(first)) return false;
    }
  }
  return true;
}

/// Looks for another literal to watch; leaves `falsified` in second place when there is none.
bool Propagator::MoveWatch(const Watch& watch, Literal falsified) {
  Literal* const clause = &literals_[watch.start];
  if (clause[0] == falsified) std::swap(clause[0], clause[1]);
  if (Value(clause[0]) > 0) return false;
  for (std::uint32_t i = 2; i < watch.size; ++i) {
    if (Value(clause[i]) < 0) continue;
    std::swap(clause[1], clause[i]);
    watches_[Index(clause[1])].push_back({clause[0], watch.start, watch.size});
    return true;
  }
  return false;
}

}  // namespace latchwork::circumscription
