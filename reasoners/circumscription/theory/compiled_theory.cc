// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/theory/compiled_theory.h"

#include <algorithm>
#include <map>

namespace latchwork::circumscription {
namespace {

bool ByAtom(Literal a, Literal b) { return AtomOf(a) != AtomOf(b) ? AtomOf(a) < AtomOf(b) : a < b; }

/// Sorted, without repeated literals.
Clause Normalized(Clause clause) {
  std::sort(clause.begin(), clause.end(), ByAtom);
  clause.erase(std::unique(clause.begin(), clause.end()), clause.end());
  return clause;
}

bool IsTautology(const Clause& normalized) {
  return std::adjacent_find(normalized.begin(), normalized.end(),
                            [](Literal a, Literal b) { return a == -b; }) != normalized.end();
}

}  // namespace

CompiledTheory::CompiledTheory(const GroundTheory& theory) {
  for (const AtomInfo& atom : theory.atoms) roles_.push_back(atom.role);
  AddLevels(theory);
  AddClauses(theory);
  AddOccurrences();
}

void CompiledTheory::AddLevels(const GroundTheory& theory) {
  std::map<int, std::vector<Atom>> by_level;
  for (std::size_t i = 0; i < theory.atoms.size(); ++i) {
    const auto atom = static_cast<Atom>(i + 1);
    const AtomInfo& info = theory.atoms[i];
    if (info.role == Role::kMinimized) by_level[info.level].push_back(atom);
    if (info.role == Role::kFixed) fixed_.push_back(atom);
    if (info.role == Role::kVarying) varying_.push_back(atom);
  }
  levels_of_.assign(roles_.size(), by_level.size());
  for (auto& [level, atoms] : by_level) {
    for (const Atom atom : atoms) levels_of_[static_cast<std::size_t>(atom) - 1] = levels_.size();
    levels_.push_back(std::move(atoms));
  }
}

void CompiledTheory::AddClauses(const GroundTheory& theory) {
  starts_.push_back(0);
  for (const Clause& clause : theory.clauses) {
    const Clause normalized = Normalized(clause);
    if (IsTautology(normalized)) continue;
    literals_.insert(literals_.end(), normalized.begin(), normalized.end());
    starts_.push_back(literals_.size());
  }
}

void CompiledTheory::AddOccurrences() {
  occurrence_starts_.assign(2 * roles_.size() + 1, 0);
  for (const Literal literal : literals_) ++occurrence_starts_[Slot(literal) + 1];
  for (std::size_t i = 1; i < occurrence_starts_.size(); ++i) {
    occurrence_starts_[i] += occurrence_starts_[i - 1];
  }
  std::vector<std::size_t> next = occurrence_starts_;
  occurrences_.resize(literals_.size());
  for (std::size_t index = 0; index < clause_count(); ++index) {
    for (const Literal literal : clause(index)) {
      occurrences_[next[Slot(literal)]++] = static_cast<std::uint32_t>(index);
    }
  }
}

bool Satisfies(const Model& model, std::span<const Literal> clause) {
  return std::any_of(clause.begin(), clause.end(),
                     [&](Literal literal) { return model.Holds(literal); });
}

}  // namespace latchwork::circumscription
