// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_SEARCH_MINIMAL_MODELS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_SEARCH_MINIMAL_MODELS_H_

#include <cstddef>
#include <span>
#include <vector>

#include "reasoners/circumscription/sat/sat_solver.h"
#include "reasoners/circumscription/search/formulas.h"
#include "reasoners/circumscription/theory/compiled_theory.h"

namespace latchwork::circumscription {

/// Candidates for minimal models, the check whether one is minimal, and learning from those that
/// are not, all in one incremental SAT solver.
class MinimalModels {
 public:
  /// `theory` must outlive the object. `conflicts`: limit of each SAT call, < 0 without.
  /// `spending`: what SAT calls are charged to, if to anything; it outlives the object.
  MinimalModels(const CompiledTheory& theory, int conflicts, Spending* spending = nullptr);

  /// A model of the theory in which `latches` and `required` hold. Minimal models are among the
  /// candidates; the more is learnt, the fewer others.
  SatResult Candidate(std::span<const Literal> latches, std::span<const Literal> required,
                      Model& candidate);
  /// A candidate in which some of `agreed` (not empty) does not hold.
  SatResult Doubt(std::span<const Literal> latches, std::span<const Literal> agreed,
                  Model& candidate);
  /// A model below `model` in which `also` holds, where that is not 0. Unsatisfiable with `also`
  /// 0: `model` is minimal.
  SatResult Below(const Model& model, Literal also, Model& lower);
  /// A model whose minimized atoms are not those of the minimal `model`, and not above them.
  /// Unsatisfiable, with all fixed atoms among `latches`: all minimal models agree on these.
  SatResult Other(std::span<const Literal> latches, const Model& model, Model& other);
  /// A model with the fixed and minimized atoms of `model` in which `required` hold.
  SatResult Vary(const Model& model, std::span<const Literal> required, Model& varied);

  void Learn(const Model& model, const Model& lower) { formulas_.Learn(solver_, model, lower); }
  std::size_t learnt() const { return formulas_.learnt(); }
  std::size_t calls() const { return calls_; }

 private:
  SatResult Solve(Model& model);
  void AssumeAsIn(const Model& model, const std::vector<Atom>& atoms);
  bool SomeFalse(const Model& model, const std::vector<Atom>& level);

  const CompiledTheory& theory_;
  SatSolver solver_;
  Formulas formulas_;
  int conflicts_;
  std::size_t calls_ = 0;
  std::vector<Literal> once_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_SEARCH_MINIMAL_MODELS_H_
