// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_RELEVANCE_H_
#define LATCHWORK_PTTP_SATURATION_RELEVANCE_H_

#include <span>
#include <vector>

#include "latchwork/logic/clause.h"

namespace latchwork::pttp::saturation {

/// Which clauses to use: those of the goal, and those of the formulas that symbols bring in within
/// `depth` steps from it. A symbol brings in a formula in which no other occurs in less than
/// 1/`tolerance` as many clauses (Hoder and Voronkov, Sine Qua Non for Large Theory Reasoning,
/// CADE 2011). All clauses when there is no goal.
std::vector<bool> SelectRelevant(std::span<const logic::Clause> clauses, unsigned depth,
                                 unsigned tolerance);

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_RELEVANCE_H_
