// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_COMPILED_GOALS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_COMPILED_GOALS_H_

#include <cstddef>
#include <vector>

#include "latchwork/sdk/reasoner.h"
#include "reasoners/circumscription/rules/program.h"

namespace latchwork::circumscription {

/// A goal as a rule; its answers rest on one fact each, the instance of the goal.
struct CompiledGoal {
  std::size_t answers = 0;  ///< The relation of its answers.
  Rule rule;
};
using CompiledGoals = std::vector<CompiledGoal>;

/// Compiles the goals of a body. Goals that cannot be grounded become diagnostics.
CompiledGoals CompileGoals(const sdk::Body& body, Program& program,
                           logic::Diagnostics& diagnostics);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_COMPILED_GOALS_H_
