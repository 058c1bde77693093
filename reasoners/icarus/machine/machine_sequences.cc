// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "reasoners/icarus/machine/machine.h"

namespace latchwork::icarus {

bool Machine::Sequence() {
  const std::uint32_t skill = scopes_[scope_].skill;
  const std::span<const Value> parameters(frames_.data() + base_, code_.skills[skill].parameters);
  const std::size_t index = sequences_.Find(skill, parameters, cycle_);
  scopes_[scope_].state = static_cast<std::uint32_t>(index);
  const SequenceStates::State& state = sequences_.at(index);
  std::copy(state.environment.begin(), state.environment.end(), frames_.begin() + base_);
  return StartStep();
}

/// Asks for the present step; after the last the sequence is True.
bool Machine::StartStep() {
  const SkillCode& skill = code_.skills[scopes_[scope_].skill];
  const Instruction& steps = code_.instructions[skill.entry];
  SequenceStates::State& state = sequences_.at(scopes_[scope_].state);
  if (traced()) TraceSequence(state.step);
  if (state.step >= steps.b) {
    state.ended = options_.restart;
    pc_ = skill.entry + 1;
    return true;
  }
  PushScope(ScopeKind::kStep);
  PushChoice(ChoiceKind::kStepEnd, skill.entry);
  scope_ = static_cast<Index>(scopes_.size() - 1);
  pc_ = code_.branches[steps.a + state.step].address;
  return true;
}

/// Keeps the first environment in which the step is True; what else it comes to is still asked for.
bool Machine::StepEnd() {
  Scope& step = scopes_[scope_];
  if (!step.truth) {
    step.truth = true;
    const std::uint32_t variables = code_.skills[scopes_[step.parent].skill].variables;
    step.environment = arena_.CopyValues({frames_.data() + base_, variables}).data();
  }
  return false;
}

bool Machine::AfterStep(const Choice& choice) {
  const Scope& step = scopes_[choice.scopes - 1];
  if (!step.truth) {
    for (FoundAct* act = step.first_act; act != nullptr;) {
      FoundAct* const next = act->next;
      Emit(scope_, act);
      act = next;
    }
    return false;
  }
  for (const FoundAct* act = step.first_act; traced() && act != nullptr; act = act->next) {
    TraceAct(EventKind::kDropped, choice.scopes - 1, *act);
  }
  SequenceStates::State& state = sequences_.at(scopes_[scope_].state);
  const std::uint32_t variables = code_.skills[scopes_[scope_].skill].variables;
  state.environment.assign(step.environment, step.environment + variables);
  state.changed = true;
  ++state.step;
  std::copy_n(step.environment, variables, frames_.begin() + base_);
  return StartStep();
}

}  // namespace latchwork::icarus
