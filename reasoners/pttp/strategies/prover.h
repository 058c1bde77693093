// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PROVER_H_
#define LATCHWORK_PTTP_PROVER_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/formula.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/decision.h"
#include "reasoners/pttp/proofs/explanation.h"

namespace latchwork::pttp {

/// The words of the SZS ontology that a proof attempt can end with.
enum class Szs : std::uint8_t {
  kTheorem,
  kUnsatisfiable,
  kCounterSatisfiable,
  kSatisfiable,
  kGaveUp,
  kTimeout,
  kResourceOut,
};
std::string_view Name(Szs status);

struct ProverOptions {
  sdk::Budget budget;
  /// CPU seconds, from now on, that the schedule divides among its strategies.
  double cpu_seconds = 10.0;
  std::size_t memory_bytes = std::size_t{2} << 30U;
  bool proof = false;    ///< Write the proof down.
  bool explain = false;  ///< With `proof`: explain it as well, or keep what its lack is told from.
  /// Of each formula its text in the file, to be used in the proof; may be empty.
  std::span<const std::string> texts;
  bool answers =
      false;  ///< Only strategies that can tell the values of the conjecture's variables.
  bool saturation = true;  ///< False: the schedule has only connection tableaux.
  std::string strategy;    ///< One of Strategies(); else the schedule that suits the problem.
  /// How many strategies of the schedule run at the same time, sharing CPU time and memory. With
  /// more than one it is not determined which of several that would succeed ends the attempt.
  unsigned threads = 1;
};

struct ProverResult {
  Szs status = Szs::kGaveUp;
  std::string strategy;        ///< The one that ended the attempt.
  std::string message;         ///< Why it gave up; may be empty.
  sdk::Statistics statistics;  ///< Of all strategies together; depth: of the last.
  std::size_t clauses = 0;
  std::vector<std::string> proof;  ///< Annotated formulas, the last one derives $false.
  bool uses_conjecture = true;  ///< Whether the proof that was written down needs the conjecture.
  /// Values of the conjecture's variables, one tuple for each of its instances in the proof: at
  /// least one of them answers.
  std::vector<std::vector<std::string>> answers;
  Explanation explanation;  ///< Of the proof.
  /// With `explain`, when there is no proof: the clauses of the formulas.
  std::vector<logic::Clause> theory;
};

/// Tries to prove the conjectures among the formulas, or else that the formulas contradict each
/// other. `file` is named in the proof. Satisfiability is claimed only when a complete strategy
/// exhausted its search space and no built-in theory is involved.
ProverResult Prove(const std::vector<logic::AnnotatedFormula>& formulas,
                   logic::SymbolTable& symbols, std::string_view file,
                   const ProverOptions& options);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PROVER_H_
