// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PROVER_H_
#define LATCHWORK_PTTP_PROVER_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/formula.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/decision.h"

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
  bool proof = false;    ///< Write the proof down.
  std::string strategy;  ///< Which search to make; empty: what is best for the problem.
};

struct ProverResult {
  Szs status = Szs::kGaveUp;
  std::string message;  ///< Why it gave up; may be empty.
  sdk::Statistics statistics;
  std::size_t clauses = 0;
  std::vector<std::string> proof;  ///< Annotated formulas, the last one derives $false.
  bool uses_conjecture = true;  ///< Whether the proof that was written down needs the conjecture.
  /// Values of the conjecture's variables, one tuple for each of its instances in the proof: at
  /// least one of them answers.
  std::vector<std::vector<std::string>> answers;
};

/// Tries to prove the conjectures among the formulas, or else that the formulas contradict each
/// other. `file` is named in the proof. Satisfiability is claimed only when the search space was
/// exhausted and no built-in theory is involved.
ProverResult Prove(const std::vector<logic::AnnotatedFormula>& formulas,
                   logic::SymbolTable& symbols, std::string_view file,
                   const ProverOptions& options);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PROVER_H_
