// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/propagation.h"

#include <algorithm>
#include <utility>

namespace latchwork::pttp {

using Literal = PropositionalLiteral;
using Clause = PropositionalClause;

std::size_t Propagation::Add(Clause clause) {
  for (const Literal each : clause) {
    if (AtomOf(each) >= atoms_.size()) atoms_.resize(AtomOf(each) + 1);
  }
  watches_.resize(2 * atoms_.size());
  clauses_.push_back(std::move(clause));
  return clauses_.size() - 1;
}

bool Propagation::IsTrue(Literal literal) const {
  const AtomState& atom = atoms_[AtomOf(literal)];
  return atom.is_set && atom.value != ((literal & 1U) != 0);
}

void Propagation::Set(Literal literal, std::size_t reason) {
  AtomState& atom = atoms_[AtomOf(literal)];
  atom.is_set = true;
  atom.value = (literal & 1U) == 0;
  atom.level = marks_.size();
  atom.reason = reason;
  trail_.push_back(literal);
}

std::size_t Propagation::Watch(std::size_t index) {
  Clause& clause = clauses_[index];
  std::stable_partition(clause.begin(), clause.end(), [&](Literal each) { return !IsFalse(each); });
  if (clause.size() > 1) {
    watches_[clause[0]].push_back(index);
    watches_[clause[1]].push_back(index);
  }
  if (clause.empty() || IsFalse(clause[0])) return index;
  if (!IsTrue(clause[0]) && (clause.size() == 1 || IsFalse(clause[1]))) Set(clause[0], index);
  return kNone;
}

std::size_t Propagation::Propagate() {
  while (next_ < trail_.size()) {
    const std::size_t conflict = Visit(Negated(trail_[next_++]));
    if (conflict != kNone) return conflict;
  }
  return kNone;
}

std::size_t Propagation::Visit(Literal literal) {
  std::vector<std::size_t> visits = std::move(watches_[literal]);
  std::vector<std::size_t> kept;
  std::size_t conflict = kNone;
  for (const std::size_t index : visits) {
    if (conflict == kNone && MovesWatch(clauses_[index], literal, index)) continue;
    kept.push_back(index);
    const Literal first = clauses_[index][0];
    if (conflict != kNone || IsTrue(first)) continue;
    if (IsFalse(first)) {
      conflict = index;
    } else {
      Set(first, index);
    }
  }
  watches_[literal] = std::move(kept);
  return conflict;
}

bool Propagation::MovesWatch(Clause& clause, Literal literal, std::size_t index) {
  if (clause[0] == literal) std::swap(clause[0], clause[1]);
  if (IsTrue(clause[0])) return false;
  const auto next =
      std::find_if(clause.begin() + 2, clause.end(), [&](Literal each) { return !IsFalse(each); });
  if (next == clause.end()) return false;
  std::swap(clause[1], *next);
  watches_[clause[1]].push_back(index);
  return true;
}

// In the order in which the premises speak of atoms chains are shorter than by activity.
bool Propagation::Decide() {
  const auto open = std::find_if(atoms_.begin() + static_cast<std::ptrdiff_t>(first_open_),
                                 atoms_.end(), [](const AtomState& each) { return !each.is_set; });
  first_open_ = static_cast<std::size_t>(open - atoms_.begin());
  if (open == atoms_.end()) return false;
  marks_.push_back(trail_.size());
  Set(static_cast<Literal>(2 * first_open_ + 1), kNone);
  return true;
}

void Propagation::UndoTo(std::size_t level) {
  if (level >= marks_.size()) return;
  for (; trail_.size() > marks_[level]; trail_.pop_back()) {
    const std::size_t atom = AtomOf(trail_.back());
    atoms_[atom].is_set = false;
    first_open_ = std::min(first_open_, atom);
  }
  marks_.resize(level);
  next_ = trail_.size();
}

}  // namespace latchwork::pttp
