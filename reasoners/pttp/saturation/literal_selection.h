// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_LITERAL_SELECTION_H_
#define LATCHWORK_PTTP_SATURATION_LITERAL_SELECTION_H_

#include <span>

#include "reasoners/pttp/saturation/ordering.h"
#include "reasoners/pttp/saturation/saturate.h"
#include "reasoners/pttp/saturation/terms.h"

namespace latchwork::pttp::saturation {

/// Marks the eligible literals: one selected negative literal, or else all maximal ones. Every
/// choice among the negative literals keeps the calculus complete.
void MarkEligible(const Terms& terms, Ordering& ordering, Selection selection,
                  std::span<Literal> literals);

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_LITERAL_SELECTION_H_
