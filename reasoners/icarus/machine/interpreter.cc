// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/interpreter.h"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include "reasoners/icarus/machine/compiler.h"
#include "reasoners/icarus/machine/machine.h"
#include "reasoners/icarus/machine/query_levels.h"

namespace latchwork::icarus {

namespace {

bool SameValues(std::span<const Value> a, std::span<const Value> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), Equal);
}

bool SameAct(const Act& a, const Act& b) {
  return std::equal(a.calls.begin(), a.calls.end(), b.calls.begin(), b.calls.end(),
                    [](const ActCall& x, const ActCall& y) {
                      return x.function == y.function && SameValues(x.arguments, y.arguments);
                    });
}

bool Holds(const std::vector<Act>& acts, const Act& act) {
  return std::any_of(acts.begin(), acts.end(), [&](const Act& a) { return SameAct(a, act); });
}

std::span<const Value> CopyValues(std::span<const Value> values, Arena& arena) {
  const std::span<Value> copy = arena.MakeValues(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) copy[i] = arena.Copy(values[i]);
  return copy;
}

Act CopyAct(const Act& act, Arena& arena) {
  auto* const calls = static_cast<ActCall*>(arena.Allocate(act.calls.size() * sizeof(ActCall)));
  for (std::size_t i = 0; i < act.calls.size(); ++i) {
    ::new (calls + i) ActCall{act.calls[i].function, CopyValues(act.calls[i].arguments, arena)};
  }
  return {act.skill, CopyValues(act.arguments, arena), {calls, act.calls.size()}, act.path};
}

}  // namespace

void GetPath(const Act& act, std::vector<const PathSkill*>& path) {
  path.clear();
  for (const PathSkill* at = act.path; at != nullptr; at = at->caller) path.push_back(at);
  std::reverse(path.begin(), path.end());
}

struct Interpreter::Implementation {
  struct Top {
    Address entry;
    std::vector<std::string> variables;
    std::unique_ptr<const SourceTree> source;  ///< Null: that of the program.
  };
  /// What was issued in one cycle, in memory of its own: it is compared with the next.
  struct Issued {
    Arena arena;
    std::vector<Act> acts;
  };

  Implementation(const Program& the_program, Host& the_host, NamePool& the_names,
                 const RunOptions& the_options)
      : program(the_program),
        host(the_host),
        names(the_names),
        options(the_options),
        code(Compile(program, host, names, constants, findings)),
        machine(code, program, host, options, names, memory),
        queries(code, program, host, options, names, memory) {
    for (const Value& fact : code.facts) memory.Store(fact);
  }

  std::size_t AddTop(const Skill& query, const SourceTree& source, Findings& new_findings) {
    const Address entry =
        CompileTop(program, query, source, host, code, names, constants, new_findings);
    tops.push_back({entry, query.variables, nullptr});
    return tops.size() - 1;
  }

  Issued& now() { return issued[cycle % 2]; }
  Issued& before() { return issued[(cycle + 1) % 2]; }

  void Issue() {
    Issued& fresh = now();
    fresh.arena.Reset();
    fresh.acts.clear();
    stopped.clear();
    for (const FoundAct* found : machine.acts()) {
      if (fresh.acts.empty() || !Holds(fresh.acts, found->act)) {
        fresh.acts.push_back(CopyAct(found->act, fresh.arena));
      }
    }
    for (Act& act : fresh.acts) act.started = !Holds(before().acts, act);
    for (Act& act : before().acts) {
      act.path = nullptr;
      if (!Holds(fresh.acts, act)) stopped.push_back(act);
    }
    for (const Act& act : fresh.acts) {
      for (const ActCall& call : act.calls) ChangeMemory(call);
    }
  }

  /// What acts do to memory is done when they are issued.
  void ChangeMemory(const ActCall& call) {
    if (call.function == store) {
      memory.Store(call.arguments[0]);
    } else if (call.function == forget) {
      memory.Forget(call.arguments[0]);
    } else if (call.function == update) {
      memory.Update(call.arguments[0], call.arguments[1]);
    }
  }

  const Program& program;
  Host& host;
  NamePool& names;
  const RunOptions options;
  const NameId store = names.Intern("store");
  const NameId forget = names.Intern("forget");
  const NameId update = names.Intern("update");
  Arena constants;
  Findings findings;
  CompiledProgram code;
  FactStore memory;
  Machine machine;
  QueryLevels queries;
  std::vector<Top> tops;
  std::array<Issued, 2> issued;
  std::vector<Act> stopped;
  std::uint64_t cycle = 0;
  bool halted = false;  ///< By a fault.
  CycleResult result;
};

Interpreter::Interpreter(const Program& program, Host& host, NamePool& names,
                         const RunOptions& options)
    : implementation_(std::make_unique<Implementation>(program, host, names, options)) {}

Interpreter::~Interpreter() = default;

const Findings& Interpreter::findings() const { return implementation_->findings; }

std::size_t Interpreter::AddTop(std::string text, Findings& findings) {
  Implementation& own = *implementation_;
  Findings found;
  TopCall top = ReadTop(own.program, std::move(text), found);
  findings.insert(findings.end(), found.begin(), found.end());
  if (HasErrors(found)) return kNoTop;
  const std::size_t added = own.AddTop(top.query, top.source, findings);
  own.tops.back().source = std::make_unique<const SourceTree>(std::move(top.source));
  return added;
}

std::size_t Interpreter::AddTop(Findings& findings) {
  Implementation& own = *implementation_;
  if (!own.program.top) return kNoTop;
  return own.AddTop(*own.program.top, own.program.source, findings);
}

std::size_t Interpreter::AddNever(std::size_t index, Findings& findings) {
  Implementation& own = *implementation_;
  return own.AddTop(own.program.nevers.at(index), own.program.source, findings);
}

std::string Interpreter::TopText(std::size_t top) const {
  const FormId form = implementation_->code.instructions[implementation_->tops.at(top).entry].form;
  return std::string(TopSource(top).Text(form));
}

const SourceTree& Interpreter::TopSource(std::size_t top) const {
  const Implementation& own = *implementation_;
  const Implementation::Top& at = own.tops.at(top);
  return at.source == nullptr ? own.program.source : *at.source;
}

std::span<const std::string> Interpreter::TopVariables(std::size_t top) const {
  return implementation_->tops.at(top).variables;
}

const CycleResult& Interpreter::Cycle(std::size_t top) {
  CycleLimits limits;
  limits.depth = implementation_->options.max_depth;
  limits.clauses = implementation_->options.max_clauses;
  return Cycle(top, limits);
}

const CycleResult& Interpreter::Cycle(std::size_t top, const CycleLimits& limits) {
  Implementation& own = *implementation_;
  Machine& machine = own.machine;
  own.memory.Tidy();
  ++own.cycle;
  const bool called = top != kNoTop && !own.halted;
  const std::uint32_t variables =
      called ? static_cast<std::uint32_t>(own.tops.at(top).variables.size()) : 0;
  machine.Run(called ? own.tops[top].entry : 0, variables, own.cycle, limits);
  own.halted = own.halted || (own.options.faults == FaultMode::kStop && machine.is_aborted());
  machine.sequences().EndCycle(own.cycle, machine.is_whole());
  own.Issue();
  CycleResult& result = own.result;
  result.acts = own.now().acts;
  result.stopped = own.stopped;
  result.environments = machine.environments();
  result.values = machine.values();
  result.faults = machine.faults();
  result.fault_count = machine.fault_count();
  result.clauses = machine.clauses();
  result.is_whole = machine.is_whole();
  result.is_aborted = own.halted || machine.is_aborted();
  result.depth = machine.depth();
  result.limit = machine.limit();
  return result;
}

void Interpreter::SetValues(ValueSource* values) { implementation_->machine.SetValues(values); }

void Interpreter::SetSink(EventSink* sink) { implementation_->machine.SetSink(sink); }

std::size_t Interpreter::AddQuery(Skill query) {
  return implementation_->queries.Add(std::move(query));
}

void Interpreter::Ask(std::size_t query, EnvironmentSink& sink) {
  implementation_->queries.Ask(query, implementation_->machine, sink);
}

void Interpreter::Replay(std::size_t top, const CycleLimits& limits, EventSink& sink) {
  Implementation& own = *implementation_;
  FactStore memory;
  memory.Swap(own.memory);
  own.memory.CopyFrom(memory);
  SequenceStates sequences = own.machine.sequences().Copy();
  std::swap(sequences, own.machine.sequences());
  EventSink* const before = own.machine.sink();
  own.machine.SetSink(&sink);
  own.machine.Run(own.tops.at(top).entry,
                  static_cast<std::uint32_t>(own.tops[top].variables.size()), own.cycle, limits);
  own.machine.SetSink(before);
  std::swap(sequences, own.machine.sequences());
  own.memory.Swap(memory);
  for (Act& act : own.now().acts) act.path = nullptr;
}

namespace {

/// For each skill of `before` the number of the same skill in `now`.
std::vector<std::uint32_t> SameSkills(const Program& before, const Program& now) {
  std::vector<std::uint32_t> same;
  for (const Skill& skill : before.skills) {
    const std::uint32_t index = now.Find(skill.name);
    const bool is_same = index != kNoSkill &&
                         now.source.Text(now.skills[index].form) == before.source.Text(skill.form);
    same.push_back(is_same ? index : SequenceStates::kNoSkillHere);
  }
  return same;
}

}  // namespace

void Interpreter::TakeOver(Interpreter& other, std::size_t first_fact) {
  Implementation& own = *implementation_;
  Implementation& before = *other.implementation_;
  own.memory.Swap(before.memory);
  for (std::size_t i = first_fact; i < own.code.facts.size(); ++i) {
    own.memory.Store(own.code.facts[i]);
  }
  const std::vector<std::uint32_t> same = SameSkills(before.program, own.program);
  own.machine.sequences().TakeOver(before.machine.sequences(), same);
  own.cycle = before.cycle;
  std::swap(own.issued, before.issued);
  for (Act& act : own.now().acts) {
    act.skill = act.skill == kNoSkill ? kNoSkill : same[act.skill];
    act.path = nullptr;
  }
}

std::uint64_t Interpreter::cycle() const { return implementation_->cycle; }
FactStore& Interpreter::memory() { return implementation_->memory; }
std::size_t Interpreter::sequence_states() const {
  return implementation_->machine.sequences().size();
}

}  // namespace latchwork::icarus
