// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PROVER_PROBLEM_H_
#define LATCHWORK_PTTP_PROVER_PROBLEM_H_

#include <cstddef>
#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/clause_origins.h"
#include "latchwork/logic/formula.h"
#include "latchwork/logic/symbol.h"
#include "reasoners/pttp/terms/functors.h"

namespace latchwork::pttp {

/// A problem as every strategy finds it.
struct ProverProblem {
  ProverProblem(const std::vector<logic::AnnotatedFormula>& formulas, logic::SymbolTable& symbols,
                bool with_origins);

  /// The clauses of the formulas, for a strategy with equality built in.
  std::span<const logic::Clause> input() const { return {clauses.data(), input_size}; }
  /// With the axioms of equality that are not built into the engine.
  std::span<const logic::Clause> for_engine() const { return {clauses.data(), engine_size}; }

  std::vector<logic::Clause> clauses;  ///< With all axioms of equality.
  std::size_t input_size = 0;
  std::size_t engine_size = 0;
  logic::ClauseOrigins origins;
  bool has_conjecture = false;
  bool mentions_equality = false;
  bool has_equality = false;       ///< Some clause concludes an equation.
  bool has_arithmetic = false;     ///< An interpreted function or predicate, a number.
  Reals reals = Reals::kRounded;   ///< As it stands only where no real number can occur.
  bool has_fixed_meaning = false;  ///< That, or a distinct object: a model must respect it.
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PROVER_PROBLEM_H_
