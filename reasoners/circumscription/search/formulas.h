// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_SEARCH_FORMULAS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_SEARCH_FORMULAS_H_

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "reasoners/circumscription/sat/sat_solver.h"
#include "reasoners/circumscription/theory/compiled_theory.h"

namespace latchwork::circumscription {

/// Puts into a SAT solver what every minimal model satisfies, under a guard literal, so that
/// without the guard the solver knows the bare theory:
/// - support: each true minimized atom is in a clause whose other literals are all false;
/// - flip formulas, learnt from a model M and a lower one N: either nothing of what N lacks holds,
///   or changing a model the way that led from M to N breaks a clause. They generalize the loop
///   formulas of Lee and Lin (2006) and mention no latches, so they stay true when latches change.
class Formulas {
 public:
  /// `theory` must outlive the object; `solver` holds its clauses.
  Formulas(const CompiledTheory& theory, SatSolver& solver);

  Literal guard() const { return guard_; }
  std::size_t learnt() const { return learnt_; }

  /// Adds the flip formula of the step from `model` to the lower model `lower`.
  void Learn(SatSolver& solver, const Model& model, Model lower);

 private:
  /// What distinguishes a lower model from the one above it.
  struct Step {
    std::vector<Literal> lost;  ///< Minimized atoms of the first differing level, as literals of M.
    std::vector<Literal> changed;  ///< All differing atoms, `lost` among them, as literals of N.
  };

  void AddSupport(SatSolver& solver, Atom atom);
  Step Difference(const Model& model, const Model& lower) const;
  /// Undoes parts of the step, one atom at a time, as long as `lower` stays a lower model.
  void Shrink(const Model& model, Model& lower);
  bool Undo(Atom atom, Model& lower);
  /// A literal that implies that all of `literals` are false.
  Literal AllFalse(SatSolver& solver, const Clause& literals);

  const CompiledTheory& theory_;
  Literal guard_;
  std::size_t learnt_ = 0;
  std::map<Clause, Literal> all_false_;
  std::vector<std::uint32_t> true_literals_;  ///< Per clause; only within Shrink.
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_SEARCH_FORMULAS_H_
