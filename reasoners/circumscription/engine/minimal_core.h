// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_ENGINE_MINIMAL_CORE_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_ENGINE_MINIMAL_CORE_H_

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

class Spending;

/// Latches and clauses that contradict each other, and do no longer when any one is left out.
struct Core {
  std::vector<Literal> latches;
  std::vector<std::size_t> clauses;  ///< Places in GroundTheory::clauses.
};

/// Nothing: the theory has a model under the latches. Each part is left out in turn, so this is for
/// reports and not for control cycles. `conflicts`: limit of each SAT call, < 0 without.
/// `spending`: what the calls are charged to, if to anything. Where a limit is reached, the core
/// may be larger than need be.
std::optional<Core> MinimalCore(const GroundTheory& theory, std::span<const Literal> latches,
                                int conflicts = -1, Spending* spending = nullptr);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_ENGINE_MINIMAL_CORE_H_
