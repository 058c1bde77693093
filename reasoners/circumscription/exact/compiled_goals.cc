// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/exact/compiled_goals.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace latchwork::circumscription {

CompiledGoals CompileGoals(const sdk::Body& body, Program& program,
                           logic::Diagnostics& diagnostics) {
  CompiledGoals goals;
  for (const sdk::Goal& goal : body.goals) {
    const logic::Literal literal{true, goal.pattern};
    CompiledGoal compiled;
    compiled.answers = program.AddAnswers(goal.variables);
    std::string problem;
    auto rule = program.CompileQuery({&literal, 1}, goal.variables, compiled.answers, problem);
    if (rule) {
      compiled.rule = *std::move(rule);
    } else {
      diagnostics.push_back(
          {{},
           fmt::format("goal {} cannot be grounded: {}", ToString(goal.pattern), problem),
           "",
           ""});
    }
    goals.push_back(std::move(compiled));
  }
  return goals;
}

}  // namespace latchwork::circumscription
