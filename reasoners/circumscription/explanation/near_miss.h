// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_NEAR_MISS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_NEAR_MISS_H_

#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/explanation.h"
#include "reasoners/circumscription/evaluation/evaluator.h"

namespace latchwork::circumscription {

/// Why nothing concludes `target` in the model of the last evaluation: for each clause that might,
/// the farthest it gets; the nearest one first. Variables of `target` stand for anything, a
/// repeated one for the same. For reports: every way through the premises is tried, up to a limit.
std::vector<sdk::NearMiss> NearMissesOf(const logic::Atom& target, const Evaluator& evaluator,
                                        logic::SymbolTable& symbols);

/// Adds what clauses lack of which `misses` says nothing yet, after it.
void AddMisses(std::vector<sdk::NearMiss> more, std::vector<sdk::NearMiss>& misses);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_NEAR_MISS_H_
