// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_CHECK_PROOF_PROOF_CHECKER_H_
#define LATCHWORK_APPS_CHECK_PROOF_PROOF_CHECKER_H_

#include <cstdint>
#include <string>
#include <vector>

#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/logic/tptp.h"

namespace latchwork::check_proof {

enum class StepState : std::uint8_t { kVerified, kRejected, kUnchecked };

struct CheckedStep {
  std::string name;
  logic::SourcePlace place;
  StepState state = StepState::kVerified;
  std::string reason;  ///< Unless it is verified.
};

/// Checks a refutation in TSTP syntax against its problem, step by step, with means of its own:
/// - a leaf is the formula of that name in the problem, up to the names of variables;
/// - `cth` is the negation of all conjectures together, and nothing else follows from a conjecture;
/// - a definition names a formula by a new predicate; `esa` puts new functions for existential
///   variables;
/// - `thm` follows from its parents: as an instance, as a normal form, by propositional logic, or
/// by
///   a small refutation;
/// - names are unique, parents come first, the last step is $false.
/// `proof` was read with keep_sources, with the same symbols as the problem. Gives every step, in
/// order, and what is wrong with the whole as a step without a name.
std::vector<CheckedStep> CheckProof(const logic::TptpFile& problem, const logic::TptpFile& proof,
                                    logic::SymbolTable& symbols);

}  // namespace latchwork::check_proof

#endif  // LATCHWORK_APPS_CHECK_PROOF_PROOF_CHECKER_H_
