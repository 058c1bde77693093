// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_AGENT_THEORY_H_
#define LATCHWORK_APPS_LATCHWORK_AGENT_THEORY_H_

#include <string>
#include <vector>

#include "apps/latchwork/command.h"
#include "apps/latchwork/semantics_problem.h"

namespace latchwork::app {

/// Makes a layered theory of an agent: of each layer its TPTP body, ground over the constants in
/// it, the layer's parameters and `facts` ("LAYER: atom", what its sensors say); of each wire
/// between neighbours a bridge for every instance of a goal that occurs above. Asked is each
/// instance of a goal of the lowest layer, and its negation. A layer that is no finite theory is
/// refused, with the places that make it none.
SemanticsProblem ReadAgentProblem(const std::string& file, const std::vector<std::string>& facts,
                                  const Context& context);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_AGENT_THEORY_H_
