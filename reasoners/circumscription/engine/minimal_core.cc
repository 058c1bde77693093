// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/engine/minimal_core.h"

#include <algorithm>

#include "reasoners/circumscription/sat/sat_solver.h"

namespace latchwork::circumscription {
namespace {

/// Of the assumptions those that the solver needed for its last refutation.
std::vector<Literal> Needed(SatSolver& solver, const std::vector<Literal>& assumptions) {
  std::vector<Literal> needed;
  std::copy_if(assumptions.begin(), assumptions.end(), std::back_inserter(needed),
               [&](Literal literal) { return solver.Failed(literal); });
  return needed;
}

/// Deletion: what can be left out is, and with it all that the refutation did not need.
std::vector<Literal> Minimized(SatSolver& solver, std::vector<Literal> core, int conflicts) {
  for (std::size_t i = 0; i < core.size();) {
    std::vector<Literal> rest = core;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    solver.Assume(rest);
    if (solver.Solve(conflicts) == SatResult::kUnsatisfiable) {
      core = Needed(solver, rest);
    } else {
      ++i;
    }
  }
  return core;
}

}  // namespace

std::optional<Core> MinimalCore(const GroundTheory& theory, std::span<const Literal> latches,
                                int conflicts, Spending* spending) {
  const auto atoms = static_cast<int>(theory.atoms.size());
  SatSolver solver(atoms);
  if (spending != nullptr) solver.Charge(*spending);
  std::vector<Literal> assumptions;
  for (const Clause& clause : theory.clauses) {
    Clause selected = clause;
    selected.push_back(-solver.NewVariable());
    solver.Add(selected);
    assumptions.push_back(-selected.back());
  }
  // Latches come last: a core is easier to read with few clauses, so these are left out first.
  assumptions.insert(assumptions.end(), latches.begin(), latches.end());
  solver.Assume(assumptions);
  if (solver.Solve(conflicts) != SatResult::kUnsatisfiable) return std::nullopt;
  Core core;
  for (const Literal literal : Minimized(solver, Needed(solver, assumptions), conflicts)) {
    if (AtomOf(literal) <= atoms) {
      core.latches.push_back(literal);
    } else {
      core.clauses.push_back(static_cast<std::size_t>(literal - atoms) - 1);
    }
  }
  return core;
}

}  // namespace latchwork::circumscription
