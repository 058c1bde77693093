// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <string>

#include "reasoners/icarus/machine/machine.h"

namespace latchwork::icarus {

namespace {

constexpr std::string_view kTooLarge = "the list is too deep or too large";

bool Overflows(Builtin builtin, std::int64_t a, std::int64_t b, std::int64_t& result) {
  switch (builtin) {
    case Builtin::kAdd:
      return __builtin_add_overflow(a, b, &result);
    case Builtin::kSubtract:
      return __builtin_sub_overflow(a, b, &result);
    default:
      return __builtin_mul_overflow(a, b, &result);
  }
}

double Apply(Builtin builtin, double a, double b) {
  switch (builtin) {
    case Builtin::kAdd:
      return a + b;
    case Builtin::kSubtract:
      return a - b;
    case Builtin::kMultiply:
      return a * b;
    default:
      return a / b;
  }
}

/// The nearest integer, halves away from zero; none where it does not fit.
Value Rounded(const Value& value) {
  constexpr double kBound = 0x1p63;
  if (value.kind == ValueKind::kInteger) return value;
  const double rounded = std::round(value.real);
  if (!(rounded >= -kBound && rounded < kBound)) return {};
  return Value::Integer(static_cast<std::int64_t>(rounded));
}

}  // namespace

Value Machine::EvaluateOther(const TermCode& term, Index base) {
  switch (term.kind) {
    case TermCode::Kind::kList:
      return EvaluateList(term, base);
    case TermCode::Kind::kCall:
      return CallFunction(term.a, base);
    case TermCode::Kind::kCycle:
      return Value::Integer(static_cast<std::int64_t>(cycle_));
    default:
      return {};
  }
}

/// With every `?` as none.
Value Machine::EvaluatePattern(const TermCode& term, Index base) {
  const bool list = term.kind == TermCode::Kind::kList;
  return list ? EvaluateList(term, base, true) : Evaluate(term, base);
}

Value Machine::EvaluateList(const TermCode& term, Index base, bool pattern) {
  const std::size_t mark = scratch_.size();
  bool ground = true;
  for (std::uint32_t i = 0; ground && i < term.b; ++i) {
    const TermCode& part = code_.terms[term.a + i];
    const Value item = pattern ? EvaluatePattern(part, base) : Evaluate(part, base);
    ground = !item.is_none() || (pattern && part.kind == TermCode::Kind::kAnything);
    scratch_.Push(item);
  }
  Value list;
  if (ground) {
    list = arena_.MakeList(Arguments(mark));
    if (list.is_none()) Fail(clause_form_, kTooLarge);
  }
  scratch_.Shrink(mark);
  return list;
}

void Machine::SetVariable(Index at, const Value& value) {
  frames_[at] = value;
  trail_.Push(at);
}

void Machine::UndoBindings(std::size_t mark) {
  while (trail_.size() > mark) {
    frames_[trail_.back()] = Value();
    trail_.Pop();
  }
}

bool Machine::Unify(const TermCode& term, const Value& value, Index base) {
  switch (term.kind) {
    case TermCode::Kind::kValue:
      return Equal(term.value, value);
    case TermCode::Kind::kVariable:
      if (!frames_[base + term.a].is_none()) return Equal(frames_[base + term.a], value);
      SetVariable(base + term.a, value);
      return true;
    case TermCode::Kind::kAnything:
      return true;
    case TermCode::Kind::kList: {
      if (value.kind != ValueKind::kList || value.list->size != term.b) return false;
      const std::span<const Value> items = value.list->items();
      for (std::uint32_t i = 0; i < term.b; ++i) {
        if (!Unify(code_.terms[term.a + i], items[i], base)) return false;
      }
      return true;
    }
    default: {
      const Value own = Evaluate(term, base);
      return !own.is_none() && Equal(own, value);
    }
  }
}

bool Machine::Bind(const Instruction& instruction) {
  if (!Spend(instruction.form)) return false;
  clause_form_ = instruction.form;
  ++pc_;
  const TermCode& term = code_.terms[instruction.b];
  const Value value = frames_[base_ + instruction.a];
  if (!value.is_none()) return Unify(term, value, base_);
  const Value bound = Evaluate(term, base_);
  if (bound.is_none()) {
    if (term.kind != TermCode::Kind::kCall) {
      Fail(instruction.form, "nothing to bind the variable to");
    }
    return false;
  }
  SetVariable(base_ + instruction.a, bound);
  return true;
}

bool Machine::TakeApart(const Instruction& instruction) {
  if (!Spend(instruction.form)) return false;
  clause_form_ = instruction.form;
  ++pc_;
  const TermCode& term = code_.terms[instruction.b];
  const Value value = Evaluate(term, base_);
  if (!value.is_none()) return Unify(code_.terms[instruction.a], value, base_);
  if (term.kind != TermCode::Kind::kCall) {
    Fail(instruction.form, "nothing to bind the variables to");
  }
  return false;
}

/// Appends the arguments to `scratch_`; false, and nothing appended, when one has no value.
bool Machine::PushArguments(const CallCode& call, Index base) {
  const std::size_t mark = scratch_.Reserve(call.count);
  for (std::uint32_t i = 0; i < call.count; ++i) {
    const TermCode& term = code_.terms[call.first + i];
    const Value value = Evaluate(term, base);
    if (value.is_none()) {
      if (term.kind != TermCode::Kind::kCall) {
        Fail(call.form, "an argument of the call has an unbound variable");
      }
      scratch_.Shrink(mark);
      return false;
    }
    scratch_[mark + i] = value;
  }
  return true;
}

inline Value Machine::AskHost(const CallCode& call, std::span<const Value> arguments) {
  try {
    const Value answer = host_.Call(call.function, arguments, arena_, names_);
    if (traced()) TraceHost(EventKind::kHost, call, arguments, answer);
    return answer;
  } catch (const std::exception& thrown) {
    FailHost(call, arguments, thrown.what());
  } catch (...) {
    FailHost(call, arguments, "failed");
  }
  return {};
}

Value Machine::CallOther(const CallCode& call, Index base) {
  if (call.kind == CallCode::Kind::kChange) return ChangeMemory(call, base);
  const std::size_t mark = scratch_.size();
  if (!PushArguments(call, base)) return {};
  const std::span<const Value> arguments = Arguments(mark);
  const Value answer = call.kind == CallCode::Kind::kBuiltin ? CallBuiltin(call, arguments)
                                                             : AskHost(call, arguments);
  scratch_.Shrink(mark);
  return answer;
}

/// Whether the call is the same as it was when it was asked here last.
inline bool Machine::IsAsBefore(const CallCode& call, const SensorCache::Call& last,
                                Index base) const {
  const ArgumentSlot* const slots = code_.slots.data() + call.first_slot;
  for (std::uint32_t i = 0; i < call.slots; ++i) {
    if (!Equal(frames_[base + slots[i].slot], last.arguments[slots[i].argument])) return false;
  }
  return call.comparable;
}

/// The call as the cache knows it; null: an argument has no value.
SensorCache::Call* Machine::FindCall(const CallCode& call, std::uint32_t index, Index base) {
  const std::size_t mark = scratch_.size();
  if (!PushArguments(call, base)) return nullptr;
  SensorCache::Call* const found = &cache_.Find(index, call.function, Arguments(mark));
  scratch_.Shrink(mark);
  return found;
}

Value Machine::CallHost(const CallCode& call, std::uint32_t index, Index base) {
  SensorCache::Call* known = cache_.Last(index);
  if (known == nullptr || !IsAsBefore(call, *known, base)) {
    known = FindCall(call, index, base);
    if (known == nullptr) return {};
  }
  if (cache_.IsAnswered(*known)) {
    if (traced()) TraceHost(EventKind::kKnown, call, known->values(), known->answer);
    return known->answer;
  }
  const Value answer = AskHost(call, known->values());
  cache_.Keep(*known, answer);
  return answer;
}

void Machine::FailHost(const CallCode& call, std::span<const Value> arguments, const char* error) {
  if (traced()) TraceHost(EventKind::kHost, call, arguments, {}, error);
  Fail(call.form, "{" + std::string(names_.Name(call.name)) + "}: " + error);
}

Value Machine::CallBuiltin(const CallCode& call, std::span<const Value> arguments) {
  const auto builtin = static_cast<Builtin>(call.function);
  switch (builtin) {
    case Builtin::kList: {
      const Value list = arena_.MakeList(arguments);
      if (list.is_none()) Fail(call.form, kTooLarge);
      return list;
    }
    case Builtin::kMember: {
      if (arguments[1].kind != ValueKind::kList) break;
      const auto items = arguments[1].list->items();
      return Truth(std::any_of(items.begin(), items.end(),
                               [&](const Value& v) { return Equal(v, arguments[0]); }));
    }
    case Builtin::kStore:
      if (arguments[0].kind != ValueKind::kList) break;
      StoreFact(call, arguments[0]);
      return true_;
    case Builtin::kEqual:
    case Builtin::kDiffers:
      return Compare(builtin, arguments[0], arguments[1]);
    default:
      if (!std::all_of(arguments.begin(), arguments.end(),
                       [](const Value& v) { return v.is_number(); })) {
        break;
      }
      if (builtin <= Builtin::kGreaterEqual) return Compare(builtin, arguments[0], arguments[1]);
      const Value result = Compute(builtin, arguments);
      if (result.is_none()) Fail(call.form, "the result is no number");
      return result;
  }
  Fail(call.form, "{" + std::string(names_.Name(call.name)) + "} is given a value of another type");
  return {};
}

Value Machine::Compare(Builtin builtin, const Value& a, const Value& b) {
  const bool numbers = a.is_number() && b.is_number();
  const bool equal = numbers ? a.number() == b.number() : Equal(a, b);
  switch (builtin) {
    case Builtin::kEqual:
      return Truth(equal);
    case Builtin::kDiffers:
      return Truth(!equal);
    case Builtin::kLess:
      return Truth(a.number() < b.number());
    case Builtin::kLessEqual:
      return Truth(a.number() <= b.number());
    case Builtin::kGreater:
      return Truth(a.number() > b.number());
    default:
      return Truth(a.number() >= b.number());
  }
}

/// Integers stay integers while they fit, but for quotients.
Value Machine::Compute(Builtin builtin, std::span<const Value> arguments) {
  if (builtin == Builtin::kRound) return Rounded(arguments[0]);
  if (builtin == Builtin::kMin || builtin == Builtin::kMax) {
    return *std::min_element(
        arguments.begin(), arguments.end(), [&](const Value& a, const Value& b) {
          return builtin == Builtin::kMin ? a.number() < b.number() : a.number() > b.number();
        });
  }
  if (builtin == Builtin::kAbs) {
    const Value& a = arguments[0];
    if (a.kind == ValueKind::kReal) return Value::Real(std::fabs(a.real));
    if (a.integer == std::numeric_limits<std::int64_t>::min()) return Value::Real(-a.number());
    return Value::Integer(a.integer < 0 ? -a.integer : a.integer);
  }
  Value result = arguments[0];
  if (arguments.size() == 1 && builtin == Builtin::kSubtract) {
    const std::array<Value, 2> negated = {Value::Integer(0), result};
    return Compute(builtin, negated);
  }
  for (const Value& next : arguments.subspan(1)) {
    std::int64_t whole = 0;
    const bool integers = result.kind == ValueKind::kInteger && next.kind == ValueKind::kInteger;
    if (integers && builtin != Builtin::kDivide &&
        !Overflows(builtin, result.integer, next.integer, whole)) {
      result = Value::Integer(whole);
    } else {
      const double real = Apply(builtin, result.number(), next.number());
      if (!std::isfinite(real)) return {};
      result = Value::Real(real);
    }
  }
  return result;
}

void Machine::StoreFact(const CallCode& call, const Value& fact) {
  const std::size_t size = memory_.size();
  if (!memory_.Store(fact)) Fail(call.form, "memory is full");
  if (traced() && memory_.size() != size) TraceMemory(EventKind::kStore, call.form, fact);
}

/// The facts that a pattern within a call is compared with.
std::pair<const FactStore::Fact*, FactStore::Chain> Machine::FactsAlike(
    const TermCode& pattern) const {
  const bool list = pattern.kind == TermCode::Kind::kList && pattern.b > 0;
  const TermCode* const head = list ? &code_.terms[pattern.a] : nullptr;
  if (head != nullptr && head->kind == TermCode::Kind::kValue &&
      head->value.kind == ValueKind::kSymbol) {
    return {memory_.First(head->value.name, pattern.b), FactStore::Chain::kHead};
  }
  return {memory_.First(), FactStore::Chain::kAll};
}

/// {forget pattern} and {update pattern e}: what unifies with the pattern, by itself, goes.
Value Machine::ChangeMemory(const CallCode& call, Index base) {
  const TermCode& pattern = code_.terms[call.first];
  Value fresh;
  if (call.count == 2) {
    fresh = Evaluate(code_.terms[call.first + 1], base);
    if (fresh.kind != ValueKind::kList) {
      Fail(call.form, "what memory is updated with is not a list without unbound variables");
      return {};
    }
  }
  const FactStore::Version version = memory_.version();
  const std::size_t mark = trail_.size();
  bool placed = fresh.is_none();
  const auto [first, chain] = FactsAlike(pattern);
  for (const FactStore::Fact* fact = first; fact != nullptr; fact = FactStore::Next(fact, chain)) {
    if (!fact->VisibleAt(version)) continue;
    const bool matches = Unify(pattern, fact->value, base);
    UndoBindings(mark);
    if (!matches) continue;
    if (placed) {
      if (!fresh.is_none() && Equal(fact->value, fresh)) continue;
      memory_.Remove(fact);
      if (traced()) TraceMemory(EventKind::kForget, call.form, fact->value);
    } else {
      if (traced() && !Equal(fact->value, fresh)) {
        TraceMemory(EventKind::kForget, call.form, fact->value);
        TraceMemory(EventKind::kStore, call.form, fresh);
      }
      memory_.Replace(fact, fresh);
      placed = true;
    }
  }
  if (!placed) StoreFact(call, fresh);
  return true_;
}

void Machine::Fail(FormId form, std::string_view message) {
  ++fault_count_;
  if (traced()) TraceFault(form, message);
  if (options_.faults != FaultMode::kFalse) stopped_ = true;
  const bool known = std::any_of(faults_.begin(), faults_.end(), [&](const Fault& fault) {
    return fault.form == form && fault.message == message;
  });
  if (known || faults_.size() == kMostFaults) return;
  Fault fault;
  fault.form = form;
  fault.message = message;
  Index scope = scope_;
  while (scope != 0 && scopes_[scope].kind != ScopeKind::kSkill) scope = scopes_[scope].parent;
  fault.in_top = scope == 0;
  for (; scope != 0 && fault.skills.size() < kMostFaults; scope = scopes_[scope].parent) {
    const Scope& at = scopes_[scope];
    if (at.kind == ScopeKind::kSkill) fault.skills.push_back(program_.skills[at.skill].spelling);
  }
  faults_.push_back(std::move(fault));
}

}  // namespace latchwork::icarus
