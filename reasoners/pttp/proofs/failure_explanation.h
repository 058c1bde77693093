// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_FAILURE_EXPLANATION_H_
#define LATCHWORK_PTTP_FAILURE_EXPLANATION_H_

#include "latchwork/logic/symbol.h"
#include "reasoners/pttp/proofs/explanation.h"
#include "reasoners/pttp/strategies/prover.h"

namespace latchwork::pttp {

/// Why no proof was found: what ended the search; what is needed but concluded by nothing, or
/// occurs only in the conjecture, with the name that may have been meant; and where attempts to
/// prove the conjecture came to a goal that nothing matched, with what came nearest to matching it.
/// From a short search of its own through `result.theory`, the same for the same theory; bounded in
/// time and memory whatever the theory.
Explanation ExplainFailure(const ProverResult& result, const ProverOptions& options,
                           logic::SymbolTable& symbols);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_FAILURE_EXPLANATION_H_
