// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/certificate/propagator.h"

#include <utility>

namespace latchwork::circumscription {

Propagator::Propagator(const CompiledTheory& theory)
    : middle_(theory.atom_count()),
      values_(2 * theory.atom_count() + 1, 0),
      watches_(2 * theory.atom_count() + 1) {
  trail_.reserve(theory.atom_count());
  for (std::size_t i = 0; i < theory.clause_count(); ++i) AddClause(theory.clause(i));
  refuted_ = !Propagate() || refuted_;
  root_ = trail_.size();
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
  while (trail_.size() > root_) {
    values_[Index(trail_.back())] = 0;
    values_[Index(-trail_.back())] = 0;
    trail_.pop_back();
  }
  next_ = root_;
}

bool Propagator::Propagate() {
  if (refuted_) return false;
  while (next_ < trail_.size()) {
    if (!Visit(-trail_[next_++])) return false;
  }
  return true;
}

bool Propagator::Visit(Literal falsified) {
  std::vector<Watch>& watches = watches_[Index(falsified)];
  std::size_t kept = 0;
  bool consistent = true;
  for (std::size_t i = 0; i < watches.size(); ++i) {
    const Watch watch = watches[i];
    if (!consistent || Value(watch.other) > 0) {
      watches[kept++] = watch;
    } else if (watch.start == kBinary) {
      watches[kept++] = watch;
      consistent = Assign(watch.other);
    } else if (!MoveWatch(watch, falsified)) {
      Literal* const clause = &literals_[watch.start];
      watches[kept++] = {clause[0], watch.start, watch.size};
      consistent = Assign(clause[0]);
    }
  }
  watches.resize(kept);
  return consistent;
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
