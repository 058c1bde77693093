// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SCHEDULE_H_
#define LATCHWORK_PTTP_SCHEDULE_H_

#include <span>
#include <string_view>
#include <vector>

#include "reasoners/pttp/saturation/saturate.h"
#include "reasoners/pttp/strategies/prover_problem.h"
#include "reasoners/pttp/strategies/strategy.h"

namespace latchwork::pttp {

/// One way to search for a proof.
struct NamedStrategy {
  enum class Method : std::uint8_t {
    kTableau,     ///< Connection tableau.
    kSaturation,  ///< Superposition from all clauses.
    kEngine,      ///< The control loop's machine, which knows arithmetic.
  };
  std::string_view name;
  Method method = Method::kTableau;
  Strategy tableau;
  saturation::Options saturation;
  bool complete = false;
  std::string_view help;
};

/// All strategies, by name: what `--strategy` chooses from and its help lists.
std::span<const NamedStrategy> Strategies();
const NamedStrategy* FindStrategy(std::string_view name);

/// A strategy and the share of the time that is left which it gets.
struct Slice {
  const NamedStrategy* strategy;
  double share;
};

/// What is tried one after the other when nobody chose.
std::vector<Slice> ScheduleFor(const ProverProblem& problem);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_SCHEDULE_H_
