// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_GROUNDING_QUANTIFIERS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_GROUNDING_QUANTIFIERS_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "latchwork/logic/formula.h"

namespace latchwork::circumscription {

/// Replaces the quantifiers that would need Skolem functions by disjunctions and conjunctions over
/// the domain, which is not empty: nothing else exists. Those that become variables of clauses
/// stay. Nothing, where the result would have more than `max_atoms` atoms, or nests deeper than
/// 1,000.
std::optional<logic::Formula> ExpandExistentials(const logic::Formula& formula,
                                                 const std::vector<logic::Term>& domain,
                                                 std::size_t max_atoms);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_GROUNDING_QUANTIFIERS_H_
