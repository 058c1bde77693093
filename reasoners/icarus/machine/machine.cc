// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/machine.h"

#include <algorithm>
#include <new>

namespace latchwork::icarus {

Machine::Machine(const CompiledProgram& code, const Program& program, Host& host,
                 const RunOptions& options, NamePool& names, FactStore& memory)
    : code_(code),
      program_(program),
      host_(host),
      options_(options),
      names_(names),
      memory_(memory),
      true_(Value::Symbol(names.Intern("t"))) {}

/// False: this way has come to its end.
[[gnu::always_inline]] inline bool Machine::Step(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::kCall:
      return Call(instruction);
    case Op::kTest:
      return Test(instruction);
    case Op::kBind:
      return Bind(instruction);
    case Op::kTakeApart:
      return TakeApart(instruction);
    case Op::kMatch:
      return Match(instruction);
    case Op::kNot:
      return Negate(instruction);
    case Op::kNotEnd:
      scopes_[scope_].truth = true;
      return false;
    case Op::kObjective:
      if (instruction.b == 1 && !traced()) return TestObjective(instruction);
      PushChoice(ChoiceKind::kObjective, instruction.a);
      scopes_[scope_].in_objective = true;
      ++pc_;
      return true;
    case Op::kMeans:
      if (instruction.b != 1 || options_.expansion != Expansion::kAll) return Means(instruction);
      ++pc_;
      return true;
    case Op::kSequence:
      return Sequence();
    case Op::kStepEnd:
      return StepEnd();
    case Op::kAct:
      return MakeAct(instruction);
    case Op::kExit:
      return Exit();
    case Op::kTopEnd:
      return TopEnd();
    case Op::kFail:
      return false;
  }
  return false;
}

template <bool kTraced>
void Machine::Loop() {
  const Instruction* const instructions = code_.instructions.data();
  while (!stopped_) {
    const Instruction& instruction = instructions[pc_];
    const Index scope = scope_;
    const std::size_t mark = trail_.size();
    const bool going = Step(instruction);
    if (kTraced) TraceStep(instruction, going, scope, mark);
    if (!going && (stopped_ || !Backtrack<kTraced>())) return;
  }
}

void Machine::Run(Address entry, std::uint32_t variables, std::uint64_t cycle,
                  const CycleLimits& limits) {
  arena_.Reset();
  cache_.Begin(code_.calls.size());
  acts_.clear();
  environment_values_.clear();
  environments_ = 0;
  faults_.clear();
  fault_count_ = 0;
  clauses_ = next_check_ = 0;
  depth_ = 0;
  limits_ = limits;
  limit_ = LimitHit::kNone;
  stopped_ = false;
  trail_.Shrink(0);
  choices_.Shrink(0);
  scratch_.Shrink(0);
  scopes_.Shrink(0);
  scopes_.Push() = Scope();
  frames_top_ = 0;
  base_ = PushFrame(variables);
  scope_ = 0;
  pc_ = entry;
  cycle_ = cycle;
  top_variables_ = variables;
  events_ = 0;
  call_ends_ = options_.acts == ActMode::kValue || traced();
  if (traced()) {
    Loop<true>();
  } else {
    Loop<false>();
  }
  if (is_aborted()) DiscardOutcome();
  if (traced()) TraceEnd();
}

void Machine::DiscardOutcome() {
  stopped_ = true;
  acts_.clear();
  environments_ = 0;
  environment_values_.clear();
}

/// Once in a while; false: a limit was hit, and the clause that it is asked for is not evaluated.
bool Machine::CheckLimits(FormId form) {
  constexpr std::uint64_t kInterval = 256;
  if (clauses_ > limits_.clauses) {
    Stop(LimitHit::kClauses, form, "the cycle evaluates more clauses than the limit");
  } else if (limits_.cancelled != nullptr && limits_.cancelled->load(std::memory_order_relaxed)) {
    Stop(LimitHit::kCancelled, form, "the cycle was cancelled");
  } else if (limits_.deadline && std::chrono::steady_clock::now() >= *limits_.deadline) {
    Stop(LimitHit::kTime, form, "the cycle has no time left");
  } else {
    next_check_ = std::min(clauses_ + kInterval, limits_.clauses);
    return true;
  }
  return false;
}

CycleLimits Machine::RemainingLimits() const {
  CycleLimits left = limits_;
  left.clauses -= std::min(clauses_, left.clauses);
  return left;
}

void Machine::Charge(const Machine& other) {
  clauses_ += other.clauses_;
  next_check_ = 0;
  if (limit_ == LimitHit::kNone && other.limit_ == LimitHit::kDepth) limit_ = other.limit_;
  fault_count_ += other.fault_count_;
  for (const Fault& fault : other.faults_) {
    if (faults_.size() < kMostFaults) faults_.push_back(fault);
  }
  if (is_aborted()) stopped_ = true;
}

void Machine::Stop(LimitHit limit, FormId form, std::string_view message) {
  --clauses_;
  limit_ = limit;
  stopped_ = true;
  Fail(form, message);
}

Machine::Choice& Machine::PushChoice(ChoiceKind kind, Address pc) {
  Choice& choice = choices_.Push();
  choice.kind = kind;
  choice.pc = pc;
  choice.scope = scope_;
  choice.base = base_;
  choice.trail = static_cast<Index>(trail_.size());
  choice.values = frames_top_;
  choice.scopes = static_cast<Index>(scopes_.size());
  return choice;
}

Machine::Scope& Machine::PushScope(ScopeKind kind) {
  Scope& scope = *::new (&scopes_.Push()) Scope;
  const Scope& parent = scopes_[scope_];
  scope.kind = kind;
  scope.parent = scope_;
  scope.depth = parent.depth;
  scope.event = parent.event;
  return scope;
}

/// Makes room for so many variables, all unbound.
Machine::Index Machine::PushFrame(std::uint32_t variables) {
  const Index base = frames_top_;
  frames_top_ += variables;
  if (frames_top_ > frames_.size()) frames_.resize(std::max<std::size_t>(2 * frames_top_, 1024));
  for (Index at = base; at < frames_top_; ++at) frames_[at] = Value();
  return base;
}

template <bool kTraced>
bool Machine::Backtrack() {
  while (!choices_.empty() && !stopped_) {
    const Choice& choice = choices_.back();
    UndoBindings(choice.trail);
    frames_top_ = choice.values;
    scopes_.Shrink(choice.scopes);
    scope_ = choice.scope;
    base_ = choice.base;
    if (kTraced ? ResumeTraced(choice) : Resume(choice)) return true;
  }
  return false;
}

/// Tries what is left of the last choice; false when that led to nothing, and the choice is gone.
bool Machine::Resume(const Choice& last) {
  if (last.kind == ChoiceKind::kMeans) return TakeBranch(choices_.back());
  const Choice choice = last;
  choices_.Pop();
  switch (choice.kind) {
    case ChoiceKind::kMatch:
      pc_ = choice.pc;
      return Spend(code_.instructions[pc_].form) &&
             MatchFrom(code_.instructions[pc_], choice.fact, choice.version);
    case ChoiceKind::kObjective:
      scopes_[scope_].in_objective = false;
      pc_ = choice.pc;
      return !scopes_[scope_].any;
    case ChoiceKind::kNotEnd: {
      const Scope& negation = scopes_[choice.scopes - 1];
      pc_ = choice.pc;
      return !negation.truth && !negation.acted;
    }
    case ChoiceKind::kStepEnd:
      return AfterStep(choice);
    default:
      return AfterCall(choice);
  }
}

bool Machine::Call(const Instruction& instruction) {
  if (!Spend(instruction.form)) return false;
  const std::uint32_t depth = scopes_[scope_].depth + 1;
  if (depth > limits_.depth) {
    if (limit_ == LimitHit::kNone) limit_ = LimitHit::kDepth;
    Fail(instruction.form, "skills call each other deeper than the limit");
    return false;
  }
  depth_ = std::max(depth_, depth);
  const SkillCode& skill = code_.skills[instruction.a];
  const Index caller = base_;
  Scope& scope = PushScope(ScopeKind::kSkill);
  scope.caller_base = caller;
  scope.call = pc_;
  scope.skill = instruction.a;
  scope.depth = depth;
  if (call_ends_ && (skill.type != SkillType::kSensor || traced())) {
    PushChoice(ChoiceKind::kCallEnd, pc_);
  }
  const Index base = PushFrame(skill.variables);
  for (std::uint32_t i = 0; i < instruction.c; ++i) {
    const TermCode& term = code_.terms[instruction.b + i];
    const Value value = Evaluate(term, caller);
    if (value.is_none() && term.kind != TermCode::Kind::kAnything) scope.outputs = true;
    frames_[base + i] = value;
  }
  scope_ = static_cast<Index>(scopes_.size() - 1);
  base_ = base;
  pc_ = skill.entry;
  if (traced()) TraceCall(instruction, caller);
  if (options_.acts == ActMode::kValue && (skill.has_value || learned_ != nullptr)) {
    const Value value = ValueOfSkill(instruction.a, base);
    scope.has_value = value.is_number();
    scope.value = value.is_number() ? value.number() : 0;
  }
  return true;
}

/// An objective that binds nothing is True at most once, and needs no way back.
bool Machine::TestObjective(const Instruction& objective) {
  ++pc_;
  while (code_.instructions[pc_].op == Op::kTest) {
    if (!Test(code_.instructions[pc_])) {
      pc_ = objective.a;
      return true;
    }
  }
  return true;
}

bool Machine::Exit() {
  Scope& scope = scopes_[scope_];
  if (scope.in_objective) scope.any = true;
  const Index callee = base_;
  base_ = scope.caller_base;
  scope_ = scope.parent;
  pc_ = scope.call + 1;
  if (!scope.outputs) {
    const bool first = !scope.truth;
    scope.truth = true;
    return first;
  }
  const Instruction& call = code_.instructions[scope.call];
  for (std::uint32_t i = 0; i < call.c; ++i) {
    const Value value = frames_[callee + i];
    if (!value.is_none() && !Unify(code_.terms[call.b + i], value, base_)) return false;
  }
  if (IsRepeated(scope, call)) return false;
  scope.truth = true;
  return true;
}

/// Whether the call has already been True with what its arguments are bound to now.
bool Machine::IsRepeated(Scope& scope, const Instruction& call) {
  const std::size_t mark = scratch_.size();
  for (std::uint32_t i = 0; i < call.c; ++i) CollectVariables(code_.terms[call.b + i], base_);
  const std::span<const Value> values = Arguments(mark);
  std::uint64_t hash = values.size();
  for (const Value& value : values) hash = hash * 31 + Hash(value);
  bool repeated = false;
  for (const Seen* seen = scope.seen; seen != nullptr && !repeated; seen = seen->next) {
    repeated = seen->hash == hash && std::equal(values.begin(), values.end(), seen->values.begin(),
                                                seen->values.end(), Equal);
  }
  if (!repeated) {
    const std::span<const Value> copy = arena_.CopyValues(values);
    scope.seen = ::new (arena_.Allocate(sizeof(Seen))) Seen{hash, copy, scope.seen};
  }
  scratch_.Shrink(mark);
  return repeated;
}

void Machine::CollectVariables(const TermCode& term, Index base) {
  if (term.kind == TermCode::Kind::kVariable) scratch_.Push(frames_[base + term.a]);
  if (term.kind != TermCode::Kind::kList) return;
  for (std::uint32_t i = 0; i < term.b; ++i) CollectVariables(code_.terms[term.a + i], base);
}

/// The facts that a pattern is compared with.
FactStore::Chain Machine::ChainOf(const Instruction& pattern) const {
  if (HeadOf(pattern) == kNoName) return FactStore::Chain::kAll;
  if (pattern.c < 2) return FactStore::Chain::kHead;
  const TermCode& second = code_.terms[pattern.b + 1];
  const bool known =
      second.kind == TermCode::Kind::kValue ||
      (second.kind == TermCode::Kind::kVariable && !frames_[base_ + second.a].is_none());
  return known ? FactStore::Chain::kSecond : FactStore::Chain::kHead;
}

/// The symbol that a pattern begins with; kNoName where it does not.
NameId Machine::HeadOf(const Instruction& pattern) const {
  if (pattern.a != kNoName) return pattern.a;
  const TermCode& head = code_.terms[pattern.b];
  if (head.kind != TermCode::Kind::kVariable) return kNoName;
  const Value& value = frames_[base_ + head.a];
  return value.kind == ValueKind::kSymbol ? value.name : kNoName;
}

bool Machine::Match(const Instruction& instruction) {
  if (!Spend(instruction.form)) return false;
  const FactStore::Chain chain = ChainOf(instruction);
  const FactStore::Fact* first = nullptr;
  switch (chain) {
    case FactStore::Chain::kAll:
      first = memory_.First();
      break;
    case FactStore::Chain::kHead:
      first = memory_.First(HeadOf(instruction), instruction.c);
      break;
    case FactStore::Chain::kSecond:
      first = memory_.First(HeadOf(instruction), instruction.c,
                            Evaluate(code_.terms[instruction.b + 1], base_));
  }
  return MatchFrom(instruction, first, memory_.version());
}

bool Machine::MatchFrom(const Instruction& instruction, const FactStore::Fact* fact,
                        FactStore::Version version) {
  const FactStore::Chain chain = ChainOf(instruction);
  const std::size_t mark = trail_.size();
  while (fact != nullptr) {
    const FactStore::Fact* const next = FactStore::Next(fact, chain);
    const std::span<const Value> items = fact->value.list->items();
    bool matches = fact->VisibleAt(version) && items.size() == instruction.c;
    for (std::uint32_t i = 0; matches && i < instruction.c; ++i) {
      matches = Unify(code_.terms[instruction.b + i], items[i], base_);
    }
    if (matches) {
      if (next != nullptr) {
        Choice& choice = PushChoice(ChoiceKind::kMatch, pc_);
        choice.trail = static_cast<Index>(mark);
        choice.fact = next;
        choice.version = version;
      }
      ++pc_;
      matched_ = fact;
      return true;
    }
    UndoBindings(mark);
    fact = next;
  }
  return false;
}

bool Machine::Means(const Instruction& instruction) {
  std::uint32_t count = instruction.b;
  const std::uint32_t* order = nullptr;
  if (options_.expansion != Expansion::kAll) {
    if (options_.expansion == Expansion::kBest) order = BestMeans(instruction, count);
    count = static_cast<std::uint32_t>(std::min<std::size_t>(count, options_.means));
  }
  if (count == 0) return false;
  if (count == 1) {
    pc_ = code_.branches[order == nullptr ? instruction.a : order[0]].address;
    return true;
  }
  Choice& choice = PushChoice(ChoiceKind::kMeans, pc_);
  choice.order = order;
  choice.next = order == nullptr ? instruction.a : 0;
  choice.end = choice.next + count;
  return TakeBranch(choice);
}

bool Machine::TakeBranch(Choice& choice) {
  const std::uint32_t branch = choice.order == nullptr ? choice.next : choice.order[choice.next];
  pc_ = code_.branches[branch].address;
  if (++choice.next == choice.end) choices_.Pop();
  return true;
}

bool Machine::Negate(const Instruction& instruction) {
  if (!Spend(instruction.form)) return false;
  PushScope(instruction.b == 1 ? ScopeKind::kNotOrActing : ScopeKind::kNot).call = pc_;
  PushChoice(ChoiceKind::kNotEnd, instruction.a);
  scope_ = static_cast<Index>(scopes_.size() - 1);
  ++pc_;
  return true;
}

bool Machine::TopEnd() {
  ++environments_;
  environment_values_.insert(environment_values_.end(), frames_.begin(),
                             frames_.begin() + top_variables_);
  return false;
}

}  // namespace latchwork::icarus
