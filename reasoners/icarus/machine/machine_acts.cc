// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <new>
#include <optional>

#include "reasoners/icarus/machine/machine.h"

namespace latchwork::icarus {

namespace {

constexpr double kNoValue = -std::numeric_limits<double>::infinity();

}  // namespace

bool Machine::MakeAct(const Instruction& instruction) {
  auto* const calls = static_cast<ActCall*>(arena_.Allocate(instruction.b * sizeof(ActCall)));
  for (std::uint32_t i = 0; i < instruction.b; ++i) {
    const CallCode& call = code_.calls[instruction.a + i];
    const std::size_t mark = scratch_.size();
    const bool changes = call.kind != CallCode::Kind::kHost;
    if (!(changes ? PushChange(call) : PushArguments(call, base_))) return false;
    const std::span<const Value> arguments = arena_.CopyValues(Arguments(mark));
    scratch_.Shrink(mark);
    ::new (calls + i) ActCall{call.name, arguments};
  }
  PathSkill* const path = MakePath(scope_, base_);
  path->caller = CallersOf(scope_);
  auto* const found = ::new (arena_.Allocate(sizeof(FoundAct))) FoundAct;
  found->act = {path->skill, path->arguments, {calls, instruction.b}, path};
  found->value = kNoValue;
  if (traced()) TraceAct(EventKind::kAct, scope_, *found);
  Emit(scope_, found);
  return false;
}

/// The arguments of {store}, {forget} or {update} in an act: lists, of which a pattern may leave
/// items open. False, and nothing pushed, where they are none.
bool Machine::PushChange(const CallCode& call) {
  const std::size_t mark = scratch_.size();
  const bool pattern = call.kind == CallCode::Kind::kChange;
  for (std::uint32_t i = 0; i < call.count; ++i) {
    const TermCode& term = code_.terms[call.first + i];
    const Value value = i == 0 && pattern ? EvaluatePattern(term, base_) : Evaluate(term, base_);
    if (value.kind != ValueKind::kList) {
      Fail(call.form, value.is_none() ? "an argument of the call has an unbound variable"
                                      : "memory holds lists only");
      scratch_.Shrink(mark);
      return false;
    }
    scratch_.Push(value);
  }
  return true;
}

/// The skill of this scope, whose variables are at `base`.
PathSkill* Machine::MakePath(Index index, Index base) {
  const Scope& scope = scopes_[index];
  const SkillCode& skill = code_.skills[scope.skill];
  auto* const path =
      static_cast<PathSkill*>(arena_.Allocate(sizeof(PathSkill) + skill.variables * sizeof(Value)));
  auto* const variables = reinterpret_cast<Value*>(path + 1);
  for (std::uint32_t i = 0; i < skill.variables; ++i) {
    ::new (variables + i) Value(frames_[base + i]);
  }
  const FormId form = code_.instructions[scope.call].form;
  return ::new (path) PathSkill{
      scope.skill, form, {variables, skill.parameters}, {variables, skill.variables}, nullptr};
}

/// The callers of a skill, the nearest first. Their variables do not change while it is asked, so
/// that all acts found in it share them.
const PathSkill* Machine::CallersOf(Index index) {
  PathSkill* called = nullptr;
  for (Index at = index; at != 0;) {
    Scope& scope = scopes_[at];
    if (scope.path != nullptr) {
      if (called != nullptr) called->caller = scope.path;
      break;
    }
    const Index caller = SkillAbove(at);
    if (caller == 0) break;
    PathSkill* const made = MakePath(caller, scope.caller_base);
    scope.path = made;
    if (called != nullptr) called->caller = made;
    called = made;
    at = caller;
  }
  return scopes_[index].path;
}

Machine::Index Machine::SkillAbove(Index index) const {
  do {
    index = scopes_[index].parent;
  } while (index != 0 && scopes_[index].kind != ScopeKind::kSkill);
  return index;
}

/// An act leaves one scope after the other until one keeps it.
void Machine::Emit(Index index, FoundAct* act) {
  for (;; index = scopes_[index].parent) {
    Scope& scope = scopes_[index];
    switch (scope.kind) {
      case ScopeKind::kTop:
        AcceptAtTop(act);
        return;
      case ScopeKind::kSkill:
        if (!PassSkill(index, act)) return;
        break;
      case ScopeKind::kNot:
        scope.acted = true;
        break;
      case ScopeKind::kNotOrActing:
        scope.acted = true;
        if (traced()) TraceAct(EventKind::kDropped, index, *act);
        return;
      case ScopeKind::kStep:
        act->next = nullptr;
        (scope.first_act == nullptr ? scope.first_act : scope.last_act->next) = act;
        scope.last_act = act;
        return;
    }
  }
}

bool Machine::PassSkill(Index index, FoundAct* act) {
  Scope& scope = scopes_[index];
  if (scope.in_objective) scope.any = true;
  const bool first = !scope.acted;
  scope.acted = true;
  FoundAct* dropped = nullptr;
  switch (options_.acts) {
    case ActMode::kAll:
      return true;
    case ActMode::kFirst:
      if (first) return true;
      dropped = act;
      break;
    case ActMode::kValue:
      dropped = act;
      if (first || act->value > scope.first_act->value) std::swap(dropped, scope.first_act);
      break;
  }
  if (dropped != nullptr && traced()) TraceAct(EventKind::kDropped, index, *dropped);
  return false;
}

void Machine::AcceptAtTop(FoundAct* act) {
  FoundAct* dropped = nullptr;
  if (options_.acts == ActMode::kAll || acts_.empty()) {
    acts_.push_back(act);
  } else {
    dropped = act;
    if (options_.acts == ActMode::kValue && act->value > acts_[0]->value) {
      std::swap(dropped, acts_[0]);
    }
  }
  if (dropped != nullptr && traced()) TraceAct(EventKind::kDropped, 0, *dropped);
  if (options_.acts == ActMode::kFirst && options_.lazy && !code_.has_sequences) stopped_ = true;
}

/// The call has come to its end: its best act goes on, with the value of the skill, if it has one.
bool Machine::AfterCall(const Choice& choice) {
  const Scope& ended = scopes_[choice.scopes - 1];
  FoundAct* const best = ended.first_act;
  if (best == nullptr) return false;
  if (ended.has_value) best->value = ended.value;
  Emit(scope_, best);
  return false;
}

/// By its :value, else by what is learned; none: it has no value.
Value Machine::ValueOfSkill(std::uint32_t index, Index base) {
  const SkillCode& skill = code_.skills[index];
  if (skill.has_value) return Evaluate(code_.terms[skill.value], base);
  if (learned_ == nullptr || skill.type == SkillType::kSensor) return {};
  const std::optional<double> value =
      learned_->ValueOf(index, {frames_.data() + base, skill.parameters});
  return value ? Value::Real(*value) : Value();
}

double Machine::ValueOfBranch(const Branch& branch) {
  if (branch.skill == kNoSkill) return kNoValue;
  const SkillCode& skill = code_.skills[branch.skill];
  const Index top = frames_top_;
  const Index base = PushFrame(skill.variables);
  for (std::uint32_t i = 0; i < branch.count; ++i) {
    const Value argument = Evaluate(code_.terms[branch.first + i], base_);
    frames_[base + i] = argument;
  }
  const Value value = ValueOfSkill(branch.skill, base);
  frames_top_ = top;
  return value.is_number() ? value.number() : kNoValue;
}

/// All means by value, the highest first; equals in the order of the program.
const std::uint32_t* Machine::BestMeans(const Instruction& instruction, std::uint32_t count) {
  auto* const values = static_cast<double*>(arena_.Allocate(count * sizeof(double)));
  auto* const order = static_cast<std::uint32_t*>(arena_.Allocate(count * sizeof(std::uint32_t)));
  for (std::uint32_t i = 0; i < count; ++i) {
    values[i] = ValueOfBranch(code_.branches[instruction.a + i]);
    std::uint32_t at = i;
    for (; at > 0 && values[order[at - 1] - instruction.a] < values[i]; --at) {
      order[at] = order[at - 1];
    }
    order[at] = instruction.a + i;
  }
  return order;
}

}  // namespace latchwork::icarus
