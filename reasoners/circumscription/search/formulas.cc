// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/search/formulas.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace latchwork::circumscription {
namespace {

bool Contains(const std::vector<Literal>& literals, Literal literal) {
  return std::find(literals.begin(), literals.end(), literal) != literals.end();
}

}  // namespace

Formulas::Formulas(const CompiledTheory& theory, SatSolver& solver)
    : theory_(theory), guard_(solver.NewVariable()) {
  for (const std::vector<Atom>& level : theory.levels()) {
    for (const Atom atom : level) AddSupport(solver, atom);
  }
}

void Formulas::AddSupport(SatSolver& solver, Atom atom) {
  Clause support = {-guard_, -atom};
  for (const std::uint32_t index : theory_.Occurrences(atom)) {
    Clause others;
    for (const Literal literal : theory_.clause(index)) {
      if (literal != atom) others.push_back(literal);
    }
    if (others.empty()) return;
    support.push_back(AllFalse(solver, others));
  }
  solver.Add(support);
}

Literal Formulas::AllFalse(SatSolver& solver, const Clause& literals) {
  if (literals.size() == 1) return -literals[0];
  const auto [place, is_new] = all_false_.try_emplace(literals, 0);
  if (!is_new) return place->second;
  const Literal name = solver.NewVariable();
  place->second = name;
  for (const Literal literal : literals) solver.Add({-name, -literal});
  return name;
}

Formulas::Step Formulas::Difference(const Model& model, const Model& lower) const {
  Step step;
  std::size_t first = theory_.levels().size();
  for (std::size_t i = 1; i <= theory_.atom_count(); ++i) {
    const auto atom = static_cast<Atom>(i);
    if (model.Holds(atom) == lower.Holds(atom)) continue;
    step.changed.push_back(lower.LiteralOf(atom));
    const std::size_t level = theory_.level(atom);
    if (level < first) step.lost.clear();
    first = std::min(first, level);
    if (level == first) step.lost.push_back(atom);
  }
  return step;
}

void Formulas::Shrink(const Model& model, Model& lower) {
  true_literals_.assign(theory_.clause_count(), 0);
  for (std::size_t index = 0; index < theory_.clause_count(); ++index) {
    for (const Literal literal : theory_.clause(index)) {
      true_literals_[index] += lower.Holds(literal) ? 1U : 0U;
    }
  }
  for (bool again = true; again;) {
    again = false;
    const Step step = Difference(model, lower);
    for (const Literal literal : step.changed) {
      if (!Contains(step.lost, AtomOf(literal))) again = Undo(AtomOf(literal), lower) || again;
    }
    std::size_t left = step.lost.size();
    for (const Literal literal : step.lost) {
      if (left == 1 || !Undo(literal, lower)) continue;
      --left;
      again = true;
    }
  }
}

bool Formulas::Undo(Atom atom, Model& lower) {
  const Literal gone = lower.LiteralOf(atom);
  const auto clauses = theory_.Occurrences(gone);
  const bool breaks = std::any_of(clauses.begin(), clauses.end(),
                                  [&](std::uint32_t index) { return true_literals_[index] == 1; });
  if (breaks) return false;
  for (const std::uint32_t index : clauses) --true_literals_[index];
  for (const std::uint32_t index : theory_.Occurrences(-gone)) ++true_literals_[index];
  lower.Make(-gone);
  return true;
}

void Formulas::Learn(SatSolver& solver, const Model& model, Model lower) {
  Shrink(model, lower);
  const Step step = Difference(model, lower);
  std::vector<std::uint32_t> touched;
  for (const Literal literal : step.changed) {
    const auto clauses = theory_.Occurrences(-literal);
    touched.insert(touched.end(), clauses.begin(), clauses.end());
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());

  Clause formula = {-guard_};
  for (const std::uint32_t index : touched) {
    Clause untouched;
    bool kept = false;  // The change itself makes the clause true.
    for (const Literal literal : theory_.clause(index)) {
      kept = kept || Contains(step.changed, literal);
      if (!Contains(step.changed, -literal)) untouched.push_back(literal);
    }
    if (!kept) formula.push_back(AllFalse(solver, untouched));
  }
  formula.push_back(0);
  for (const Literal literal : step.lost) {
    formula.back() = -literal;
    solver.Add(formula);
  }
  ++learnt_;
}

}  // namespace latchwork::circumscription
