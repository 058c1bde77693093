// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/machine.h"

namespace latchwork::icarus {

/// Tells what an instruction came to. `scope` and `mark` are those that it began with.
void Machine::TraceStep(const Instruction& instruction, bool going, Index scope, std::size_t mark) {
  switch (instruction.op) {
    case Op::kTest:
      TellClause(EventKind::kTest, instruction, going, mark);
      break;
    case Op::kBind:
    case Op::kTakeApart:
      TellClause(EventKind::kBind, instruction, going, mark);
      break;
    case Op::kMatch:
      TellClause(EventKind::kMatch, instruction, going, mark);
      break;
    case Op::kExit:
      TraceExit(scope, going, mark);
      break;
    case Op::kMeans:
      if (going) TraceMeans(instruction);
      break;
    case Op::kTopEnd: {
      Event event = MakeEvent(EventKind::kTop);
      event.values = event.frame;
      Tell(event);
      break;
    }
    default:
      break;
  }
}

/// Tells how what ends here has ended, then goes back to what is still to be tried.
bool Machine::ResumeTraced(const Choice& last) {
  const Choice choice = last;
  const std::size_t mark = trail_.size();
  switch (choice.kind) {
    case ChoiceKind::kObjective: {
      Event event = MakeEvent(EventKind::kObjective);
      event.truth = scopes_[scope_].any;
      Tell(event);
      break;
    }
    case ChoiceKind::kNotEnd:
    case ChoiceKind::kStepEnd:
    case ChoiceKind::kCallEnd:
      TraceEnded(choice.kind, scopes_[choice.scopes - 1]);
      break;
    default:
      break;
  }
  const bool going = Resume(last);
  if (!going) return false;
  const Instruction& instruction = code_.instructions[choice.pc];
  if (choice.kind == ChoiceKind::kMatch) TellClause(EventKind::kMatch, instruction, true, mark, 1);
  if (choice.kind == ChoiceKind::kMeans) TraceMeans(instruction);
  return true;
}

/// An event in the present skill.
Event Machine::MakeEvent(EventKind kind) const {
  Event event;
  event.kind = kind;
  event.in = scopes_[scope_].event;
  event.depth = scopes_[scope_].depth;
  const Index skill = scopes_[scope_].kind == ScopeKind::kSkill ? scope_ : SkillAbove(scope_);
  event.body = scopes_[skill].skill;
  const std::uint32_t variables = skill == 0 ? top_variables_ : code_.skills[event.body].variables;
  event.frame = {frames_.data() + base_, variables};
  return event;
}

void Machine::Tell(Event& event) {
  event.number = ++events_;
  sink_->OnEvent(event);
}

void Machine::TellClause(EventKind kind, const Instruction& instruction, bool truth,
                         std::size_t mark, std::uint32_t index) {
  Event event = MakeEvent(kind);
  event.index = index;
  event.form = instruction.form;
  event.truth = truth;
  if (truth && kind == EventKind::kMatch) event.answer = matched_->value;
  SetBindings(event, mark);
  Tell(event);
}

/// What the present skill's variables were bound to since.
void Machine::SetBindings(Event& event, std::size_t mark) {
  bindings_.clear();
  for (std::size_t i = mark; i < trail_.size(); ++i) {
    const Index at = trail_[i] - base_;
    if (trail_[i] >= base_ && at < event.frame.size()) bindings_.push_back({at, event.frame[at]});
  }
  event.bindings = bindings_;
}

void Machine::TraceCall(const Instruction& instruction, Index caller_base) {
  const Index callee = scope_;
  const Index callee_base = base_;
  scope_ = scopes_[callee].parent;
  base_ = caller_base;
  Event event = MakeEvent(EventKind::kCall);
  scope_ = callee;
  base_ = callee_base;
  event.form = instruction.form;
  event.skill = instruction.a;
  event.depth = scopes_[callee].depth;
  event.values = {frames_.data() + callee_base, code_.skills[instruction.a].parameters};
  scopes_[callee].event = events_ + 1;
  Tell(event);
}

void Machine::TraceExit(Index callee, bool passed, std::size_t mark) {
  Event event = MakeEvent(EventKind::kTrue);
  event.form = code_.instructions[scopes_[callee].call].form;
  event.skill = scopes_[callee].skill;
  event.index = scopes_[callee].event;
  event.truth = passed;
  SetBindings(event, mark);
  Tell(event);
}

void Machine::TraceEnded(ChoiceKind kind, const Scope& ended) {
  Event event = MakeEvent(EventKind::kReturn);
  event.truth = ended.truth;
  event.acted = ended.acted || ended.first_act != nullptr;
  switch (kind) {
    case ChoiceKind::kNotEnd:
      event.kind = EventKind::kNot;
      event.form = code_.instructions[ended.call].form;
      event.truth = !ended.truth && !ended.acted;
      break;
    case ChoiceKind::kStepEnd:
      event.kind = EventKind::kStepEnd;
      event.index = sequences_.at(scopes_[scope_].state).step + 1;
      break;
    default:
      event.form = code_.instructions[ended.call].form;
      event.skill = ended.skill;
      event.index = ended.event;
  }
  Tell(event);
}

/// Which of the means is asked now.
void Machine::TraceMeans(const Instruction& instruction) {
  Event event = MakeEvent(EventKind::kMeans);
  while (event.index < instruction.b &&
         code_.branches[instruction.a + event.index].address != pc_) {
    ++event.index;
  }
  ++event.index;
  event.form = code_.instructions[pc_].form;
  Tell(event);
}

void Machine::TraceSequence(std::uint32_t step) {
  Event event = MakeEvent(EventKind::kStep);
  event.index = step + 1;
  Tell(event);
}

void Machine::TraceAct(EventKind kind, Index scope, const FoundAct& act) {
  Event event = MakeEvent(kind);
  event.in = scopes_[scope].event;
  event.depth = scopes_[scope].depth;
  event.form = act.act.path->form;
  event.skill = act.act.skill;
  event.act = &act.act;
  Tell(event);
}

void Machine::TraceHost(EventKind kind, const CallCode& call, std::span<const Value> arguments,
                        const Value& answer, std::string_view error) {
  Event event = MakeEvent(kind);
  event.form = call.form;
  event.name = call.name;
  event.values = arguments;
  event.answer = answer;
  event.truth = !answer.is_none();
  event.text = error;
  Tell(event);
}

void Machine::TraceMemory(EventKind kind, FormId form, const Value& fact) {
  Event event = MakeEvent(kind);
  event.form = form;
  event.answer = fact;
  Tell(event);
}

void Machine::TraceFault(FormId form, std::string_view message) {
  Event event = MakeEvent(EventKind::kFault);
  event.form = form;
  event.text = message;
  Tell(event);
}

void Machine::TraceEnd() {
  scope_ = 0;
  for (const FoundAct* act : acts_) TraceAct(EventKind::kChosen, 0, *act);
}

}  // namespace latchwork::icarus
