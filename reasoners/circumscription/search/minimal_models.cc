// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/search/minimal_models.h"

namespace latchwork::circumscription {
namespace {

SatSolver WithClauses(const CompiledTheory& theory) {
  SatSolver solver(static_cast<int>(theory.atom_count()));
  for (std::size_t i = 0; i < theory.clause_count(); ++i) solver.Add(theory.clause(i));
  return solver;
}

}  // namespace

MinimalModels::MinimalModels(const CompiledTheory& theory, int conflicts, Spending* spending)
    : theory_(theory),
      solver_(WithClauses(theory)),
      formulas_(theory, solver_),
      conflicts_(conflicts) {
  if (spending != nullptr) solver_.Charge(*spending);
}

SatResult MinimalModels::Solve(Model& model) {
  ++calls_;
  const SatResult result = solver_.Solve(conflicts_);
  if (result != SatResult::kSatisfiable) return result;
  model = Model(theory_.atom_count());
  for (std::size_t i = 1; i <= theory_.atom_count(); ++i) {
    const auto atom = static_cast<Atom>(i);
    if (solver_.Value(atom)) model.Make(atom);
  }
  return result;
}

SatResult MinimalModels::Candidate(std::span<const Literal> latches,
                                   std::span<const Literal> required, Model& candidate) {
  solver_.Assume(formulas_.guard());
  solver_.Assume(latches);
  solver_.Assume(required);
  return Solve(candidate);
}

SatResult MinimalModels::Doubt(std::span<const Literal> latches, std::span<const Literal> agreed,
                               Model& candidate) {
  once_.clear();
  for (const Literal literal : agreed) once_.push_back(-literal);
  solver_.Once(once_);
  return Candidate(latches, {}, candidate);
}

void MinimalModels::AssumeAsIn(const Model& model, const std::vector<Atom>& atoms) {
  for (const Atom atom : atoms) solver_.Assume(model.LiteralOf(atom));
}

/// Asks for a model in which some atom of the level that holds in `model` does not; false when
/// none holds.
bool MinimalModels::SomeFalse(const Model& model, const std::vector<Atom>& level) {
  once_.clear();
  for (const Atom atom : level) {
    if (model.Holds(atom)) once_.push_back(-atom);
  }
  if (!once_.empty()) solver_.Once(once_);
  return !once_.empty();
}

SatResult MinimalModels::Below(const Model& model, Literal also, Model& lower) {
  const auto& levels = theory_.levels();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (!SomeFalse(model, levels[i])) continue;
    solver_.Assume(formulas_.guard());
    AssumeAsIn(model, theory_.fixed());
    for (std::size_t above = 0; above < i; ++above) AssumeAsIn(model, levels[above]);
    for (const Atom atom : levels[i]) {
      if (!model.Holds(atom)) solver_.Assume(-atom);
    }
    if (also != 0) solver_.Assume(also);
    const SatResult result = Solve(lower);
    if (result != SatResult::kUnsatisfiable) return result;
  }
  return SatResult::kUnsatisfiable;
}

SatResult MinimalModels::Other(std::span<const Literal> latches, const Model& model, Model& other) {
  const auto& levels = theory_.levels();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (!SomeFalse(model, levels[i])) continue;
    solver_.Assume(formulas_.guard());
    solver_.Assume(latches);
    for (std::size_t above = 0; above < i; ++above) AssumeAsIn(model, levels[above]);
    const SatResult result = Solve(other);
    if (result != SatResult::kUnsatisfiable) return result;
  }
  return SatResult::kUnsatisfiable;
}

SatResult MinimalModels::Vary(const Model& model, std::span<const Literal> required,
                              Model& varied) {
  solver_.Assume(formulas_.guard());
  AssumeAsIn(model, theory_.fixed());
  for (const std::vector<Atom>& level : theory_.levels()) AssumeAsIn(model, level);
  solver_.Assume(required);
  return Solve(varied);
}

}  // namespace latchwork::circumscription
