// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_NEAR_MISS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_NEAR_MISS_H_

#include <cstddef>
#include <string>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "reasoners/circumscription/evaluation/evaluator.h"

namespace latchwork::circumscription {

/// How near a clause came to concluding something, and what it lacks.
struct NearMiss {
  std::string clause;
  logic::SourcePlace place;
  std::size_t met = 0;       ///< Premises that hold together.
  std::size_t premises = 0;  ///< All of them.
  std::string lacks;  ///< The next one, as far as it is known: `near(obj(3))`, `$less(2, 1)`.
};

/// Why nothing concludes `target` in the model of the last evaluation: for each clause that might,
/// the farthest it gets; the nearest one first. Variables of `target` stand for anything. For
/// reports: every way through the premises is tried, up to a limit.
std::vector<NearMiss> NearMissesOf(const logic::Atom& target, const Evaluator& evaluator,
                                   logic::SymbolTable& symbols);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_NEAR_MISS_H_
