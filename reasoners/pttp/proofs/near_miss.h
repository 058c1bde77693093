// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_NEAR_MISS_H_
#define LATCHWORK_PTTP_NEAR_MISS_H_

#include <optional>
#include <string>

#include "latchwork/logic/clause.h"
#include "reasoners/pttp/proofs/clause_index.h"

namespace latchwork::pttp {

/// `nearest edge(d, e) of fact12: argument 2 is e, wanted c`: the conclusion that agrees with the
/// goal in most arguments, and the first argument where it does not. Nothing, when no clause
/// concludes anything of the goal's predicate.
std::optional<std::string> NearMiss(const logic::Literal& goal, const ClauseIndex& index);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_NEAR_MISS_H_
