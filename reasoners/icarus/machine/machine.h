// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_MACHINE_H_
#define LATCHWORK_ICARUS_MACHINE_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoners/icarus/machine/code.h"
#include "reasoners/icarus/machine/event.h"
#include "reasoners/icarus/machine/fact_store.h"
#include "reasoners/icarus/machine/host.h"
#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/machine/sensor_cache.h"
#include "reasoners/icarus/machine/sequence_states.h"
#include "reasoners/icarus/machine/stack.h"
#include "reasoners/icarus/machine/value.h"
#include "reasoners/icarus/machine/value_source.h"

namespace latchwork::icarus {

/// An act on its way to the top.
struct FoundAct {
  Act act;
  double value = 0;
  FoundAct* next = nullptr;
};

/// Evaluates one top call: a depth-first search with explicit stacks, whose outcomes, True with
/// bindings or an act, come in one order. Registers: the next instruction, the frame of variables
/// that it works on, and the scope (a skill, a negation, a step) that an act found now belongs to.
/// A choice is what is still to be tried; going back to it undoes the bindings made since.
class Machine {
 public:
  Machine(const CompiledProgram& code, const Program& program, Host& host,
          const RunOptions& options, NamePool& names, FactStore& memory);

  /// Whole outcome of the call at `entry`, in `acts`, `environments` and `faults`.
  void Run(Address entry, std::uint32_t variables, std::uint64_t cycle, const CycleLimits& limits);

  const std::vector<FoundAct*>& acts() const { return acts_; }
  /// The values of the top call's variables, one environment after the other.
  const std::vector<Value>& values() const { return environment_values_; }
  std::size_t environments() const { return environments_; }
  const std::vector<Fault>& faults() const { return faults_; }
  std::size_t fault_count() const { return fault_count_; }
  std::uint64_t clauses() const { return clauses_; }
  /// Of the skills that called each other.
  std::uint32_t depth() const { return depth_; }
  LimitHit limit() const { return limit_; }
  std::uint64_t cycle() const { return cycle_; }
  /// What is left to spend.
  CycleLimits RemainingLimits() const;
  /// Counts what another machine did in the service of this one, and what went wrong there.
  void Charge(const Machine& other);
  bool is_whole() const { return !stopped_; }
  bool is_aborted() const { return options_.faults != FaultMode::kFalse && fault_count_ != 0; }
  SequenceStates& sequences() { return sequences_; }
  /// Takes effect with the next Run.
  void SetSink(EventSink* sink) { sink_ = sink; }
  EventSink* sink() const { return sink_; }
  void SetValues(ValueSource* values) { learned_ = values; }

 private:
  static constexpr std::size_t kMostFaults = 16;
  using Index = std::uint32_t;

  enum class ScopeKind : std::uint8_t { kTop, kSkill, kNot, kNotOrActing, kStep };
  struct Seen {
    std::uint64_t hash;
    std::span<const Value> values;
    Seen* next;
  };
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): what not all kinds have
  struct Scope {
    ScopeKind kind = ScopeKind::kTop;
    bool outputs = false;       ///< The call may bind variables of the caller.
    bool in_objective = false;  ///< Whatever is found now makes the objective not False.
    bool any = false;           ///< The objective was not False.
    bool truth = false;
    bool acted = false;
    bool has_value = false;
    Index parent = 0;
    Index caller_base = 0;
    Address call = 0;
    std::uint32_t skill = kNoSkill;
    std::uint32_t depth = 0;
    std::uint32_t event = 0;        ///< Number of the event of the skill's call, when traced.
    FoundAct* first_act = nullptr;  ///< kStep: found so far. kSkill: the best.
    Seen* seen = nullptr;
    const PathSkill* path = nullptr;  ///< kSkill: its callers, once an act was found.
    double value;                     ///< has_value.
    std::uint32_t state;              ///< kSkill of a sequence.
    FoundAct* last_act;               ///< kStep, with a first act.
    Value* environment;               ///< kStep that is True: of its first True.
  };
  enum class ChoiceKind : std::uint8_t { kMatch, kMeans, kObjective, kNotEnd, kStepEnd, kCallEnd };
  struct Choice {
    ChoiceKind kind = ChoiceKind::kMatch;
    Address pc = 0;
    Index scope = 0;
    Index base = 0;
    Index trail = 0;
    Index values = 0;
    Index scopes = 0;
    std::uint32_t next = 0;  ///< kMeans.
    std::uint32_t end = 0;
    const std::uint32_t* order = nullptr;
    const FactStore::Fact* fact = nullptr;  ///< kMatch.
    FactStore::Version version = 0;
  };

  // machine.cc
  bool Spend(FormId form) { return clauses_++ < next_check_ || CheckLimits(form); }
  bool CheckLimits(FormId form);
  void Stop(LimitHit limit, FormId form, std::string_view message);
  bool Step(const Instruction& instruction);
  template <bool kTraced>
  void Loop();
  template <bool kTraced>
  bool Backtrack();
  bool Resume(const Choice& last);
  Choice& PushChoice(ChoiceKind kind, Address pc);
  Scope& PushScope(ScopeKind kind);
  Index PushFrame(std::uint32_t variables);
  bool Call(const Instruction& instruction);
  bool TestObjective(const Instruction& objective);
  bool Exit();
  bool IsRepeated(Scope& scope, const Instruction& call);
  void CollectVariables(const TermCode& term, Index base);
  FactStore::Chain ChainOf(const Instruction& pattern) const;
  NameId HeadOf(const Instruction& pattern) const;
  bool Match(const Instruction& instruction);
  bool MatchFrom(const Instruction& instruction, const FactStore::Fact* fact,
                 FactStore::Version version);
  bool Means(const Instruction& instruction);
  bool TakeBranch(Choice& choice);
  bool Negate(const Instruction& instruction);
  bool TopEnd();
  void DiscardOutcome();

  // machine_sequences.cc
  bool Sequence();
  bool StartStep();
  bool StepEnd();
  bool AfterStep(const Choice& choice);

  // machine_acts.cc
  bool MakeAct(const Instruction& instruction);
  const PathSkill* CallersOf(Index index);
  PathSkill* MakePath(Index index, Index base);
  Index SkillAbove(Index index) const;
  void Emit(Index index, FoundAct* act);
  bool PassSkill(Index index, FoundAct* act);
  void AcceptAtTop(FoundAct* act);
  bool AfterCall(const Choice& choice);
  const std::uint32_t* BestMeans(const Instruction& instruction, std::uint32_t count);
  Value ValueOfSkill(std::uint32_t index, Index base);
  double ValueOfBranch(const Branch& branch);

  // machine_terms.cc
  /// The value; none when a variable of it is unbound, or a call of it False.
  Value Evaluate(const TermCode& term, Index base) {
    if (term.kind == TermCode::Kind::kValue) return term.value;
    if (term.kind == TermCode::Kind::kVariable) return frames_[base + term.a];
    return EvaluateOther(term, base);
  }
  Value EvaluateOther(const TermCode& term, Index base);
  Value EvaluateList(const TermCode& term, Index base, bool pattern = false);
  Value EvaluatePattern(const TermCode& term, Index base);
  bool Unify(const TermCode& term, const Value& value, Index base);
  bool Bind(const Instruction& instruction);
  bool TakeApart(const Instruction& instruction);
  void SetVariable(Index at, const Value& value);
  void UndoBindings(std::size_t mark);
  Value CallFunction(std::uint32_t index, Index base) {
    const CallCode& call = code_.calls[index];
    if (call.kind == CallCode::Kind::kHost) return CallHost(call, index, base);
    return CallOther(call, base);
  }
  bool Test(const Instruction& instruction) {
    if (!Spend(instruction.form)) return false;
    clause_form_ = instruction.form;
    ++pc_;
    return !CallFunction(instruction.a, base_).is_none();
  }
  Value CallOther(const CallCode& call, Index base);
  bool PushArguments(const CallCode& call, Index base);
  bool PushChange(const CallCode& call);
  std::span<const Value> Arguments(std::size_t mark) const {
    return {scratch_.data() + mark, scratch_.size() - mark};
  }
  Value AskHost(const CallCode& call, std::span<const Value> arguments);
  Value CallHost(const CallCode& call, std::uint32_t index, Index base);
  bool IsAsBefore(const CallCode& call, const SensorCache::Call& last, Index base) const;
  SensorCache::Call* FindCall(const CallCode& call, std::uint32_t index, Index base);
  void FailHost(const CallCode& call, std::span<const Value> arguments, const char* error);
  Value CallBuiltin(const CallCode& call, std::span<const Value> arguments);
  Value Compare(Builtin builtin, const Value& a, const Value& b);
  Value Compute(Builtin builtin, std::span<const Value> arguments);
  std::pair<const FactStore::Fact*, FactStore::Chain> FactsAlike(const TermCode& pattern) const;
  Value ChangeMemory(const CallCode& call, Index base);
  void StoreFact(const CallCode& call, const Value& fact);
  Value Truth(bool truth) const { return truth ? true_ : Value(); }
  void Fail(FormId form, std::string_view message);

  // machine_trace.cc
  bool traced() const { return sink_ != nullptr; }
  void TraceStep(const Instruction& instruction, bool going, Index scope, std::size_t mark);
  bool ResumeTraced(const Choice& last);
  Event MakeEvent(EventKind kind) const;
  void Tell(Event& event);
  void TellClause(EventKind kind, const Instruction& instruction, bool truth, std::size_t mark,
                  std::uint32_t index = 0);
  void SetBindings(Event& event, std::size_t mark);
  void TraceCall(const Instruction& instruction, Index caller_base);
  void TraceExit(Index callee, bool passed, std::size_t mark);
  void TraceEnded(ChoiceKind kind, const Scope& ended);
  void TraceMeans(const Instruction& instruction);
  void TraceSequence(std::uint32_t step);
  void TraceAct(EventKind kind, Index scope, const FoundAct& act);
  void TraceHost(EventKind kind, const CallCode& call, std::span<const Value> arguments,
                 const Value& answer, std::string_view error = {});
  void TraceMemory(EventKind kind, FormId form, const Value& fact);
  void TraceFault(FormId form, std::string_view message);
  void TraceEnd();

  const CompiledProgram& code_;
  const Program& program_;
  Host& host_;
  const RunOptions options_;
  NamePool& names_;
  FactStore& memory_;
  SequenceStates sequences_;
  SensorCache cache_;
  Arena arena_;
  Value true_;

  std::vector<Value> frames_;
  Index frames_top_ = 0;
  Stack<Index> trail_;
  Stack<Scope> scopes_;
  Stack<Choice> choices_;
  Stack<Value> scratch_;
  Address pc_ = 0;
  Index base_ = 0;
  Index scope_ = 0;
  std::uint64_t cycle_ = 0;
  std::uint64_t clauses_ = 0;
  std::uint64_t next_check_ = 0;  ///< Number of clauses after which the limits are looked at.
  std::uint32_t depth_ = 0;
  CycleLimits limits_;
  LimitHit limit_ = LimitHit::kNone;
  bool stopped_ = false;
  std::uint32_t top_variables_ = 0;

  std::vector<FoundAct*> acts_;
  std::vector<Value> environment_values_;
  std::size_t environments_ = 0;
  std::vector<Fault> faults_;
  std::size_t fault_count_ = 0;
  FormId clause_form_ = kNoForm;
  bool call_ends_ = false;  ///< The end of every call is to be seen.

  ValueSource* learned_ = nullptr;
  EventSink* sink_ = nullptr;
  std::uint32_t events_ = 0;
  const FactStore::Fact* matched_ = nullptr;
  std::vector<Binding> bindings_;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_MACHINE_H_
