// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/explain_act.h"

#include <string>
#include <utility>
#include <vector>

namespace latchwork::icarus {

namespace {

/// `near(car1, X1)`: the call of a skill as a literal; what is unbound is a variable.
std::string CallText(const PathSkill& call, const Program& program, TermBridge& bridge) {
  std::string text = logic::QuoteWord(program.skills[call.skill].spelling);
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    logic::Term term;
    const bool known = bridge.Export(call.arguments[i], term);
    text += i == 0 ? "(" : ", ";
    text += known ? ToString(term) : "X" + std::to_string(i);
  }
  if (!call.arguments.empty()) text += ')';
  return text;
}

}  // namespace

sdk::Derivation ExplainAct(const Act& act, const logic::Fact& conclusion, const Program& program,
                           TermBridge& bridge) {
  sdk::Derivation derivation;
  std::vector<const PathSkill*> path;
  GetPath(act, path);
  const auto premises = [&] {
    return derivation.steps.empty() ? std::vector<std::size_t>()
                                    : std::vector<std::size_t>{derivation.steps.size() - 1};
  };
  for (const PathSkill* const call : path) {
    sdk::DerivationStep step;
    step.conclusion = CallText(*call, program, bridge);
    step.source = program.skills[call->skill].spelling;
    if (call->form != kNoForm) step.place = program.source.Place(call->form);
    step.premises = premises();
    derivation.steps.push_back(std::move(step));
  }
  const Skill& skill = program.skills[act.skill];
  const FormId slot = skill.slot_forms[static_cast<std::size_t>(Slot::kAction)];
  derivation.steps.push_back({sdk::DerivationStep::Kind::kClause, ToString(conclusion),
                              skill.spelling, program.source.Place(slot), premises()});
  return derivation;
}

}  // namespace latchwork::icarus
