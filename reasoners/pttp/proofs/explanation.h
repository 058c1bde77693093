// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_EXPLANATION_H_
#define LATCHWORK_PTTP_EXPLANATION_H_

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "latchwork/logic/clause.h"
#include "reasoners/pttp/proofs/proof_premise.h"
#include "reasoners/pttp/proofs/tstp_printer.h"
#include "reasoners/pttp/saturation/saturate.h"

namespace latchwork::pttp {

/// One line for a person. The lines below it that are deeper say why it holds.
struct ExplanationLine {
  std::uint32_t depth = 0;
  std::string text;
};
using Explanation = std::vector<ExplanationLine>;

/// Text that is no longer than a person will read; its end may be left out.
std::string Shorten(std::string text);

/// A proof from its goal to the formulas of the file: a tree of goals, each with the formula that
/// gave it, or, when the premises are too many for that, a list of what was used. `clauses`: what
/// the premises are instances of. Propositional search of bounded length; the same input gives the
/// same lines.
Explanation ExplainProof(std::span<const logic::Clause> clauses,
                         std::span<const ProofPremise> premises, const ProofSources& sources);
/// A proof from the formulas of the file to the contradiction, step by step.
Explanation ExplainProof(std::span<const logic::Clause> clauses,
                         std::span<const saturation::Step> steps, const ProofSources& sources);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_EXPLANATION_H_
