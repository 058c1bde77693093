// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_INTERPRETER_H_
#define LATCHWORK_ICARUS_INTERPRETER_H_

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/event.h"
#include "reasoners/icarus/machine/fact_store.h"
#include "reasoners/icarus/machine/host.h"
#include "reasoners/icarus/machine/value.h"
#include "reasoners/icarus/machine/value_source.h"

namespace latchwork::icarus {

/// Which acts leave a skill: the first, all, or that of the highest :value.
enum class ActMode : std::uint8_t { kFirst, kAll, kValue };
/// Which :means are asked: all, the first n, or the n of the highest :value.
enum class Expansion : std::uint8_t { kAll, kFirst, kBest };

/// What a fault does: its clause is False and the cycle goes on; the cycle comes to nothing; or
/// that cycle and all later ones do.
enum class FaultMode : std::uint8_t { kFalse, kAbortCycle, kStop };

struct RunOptions {
  ActMode acts = ActMode::kFirst;
  Expansion expansion = Expansion::kAll;
  std::size_t means = 1;  ///< How many, with kFirst and kBest.
  std::uint32_t max_depth = 1000;
  std::uint64_t max_clauses = 1'000'000;  ///< Evaluated in one cycle; a match counts per fact.
  bool lazy = true;  ///< With kFirst, stop at the first act where no sequence is in the program.
  bool restart = false;  ///< A finished sequence starts again.
  FaultMode faults = FaultMode::kFalse;
};

/// What one cycle may spend; polled every few hundred clauses.
struct CycleLimits {
  std::uint32_t depth = 1000;
  std::uint64_t clauses = 1'000'000;
  const std::atomic<bool>* cancelled = nullptr;
  std::optional<std::chrono::steady_clock::time_point> deadline;
};

/// Which of its limits a cycle came to. At that of depth the innermost call is False and the cycle
/// goes on; every other ends it.
enum class LimitHit : std::uint8_t { kNone, kDepth, kClauses, kTime, kCancelled };

struct ActCall {
  NameId function = kNoName;
  std::span<const Value> arguments;
};

/// A skill that was being asked when an act was found.
struct PathSkill {
  std::uint32_t skill = kNoSkill;
  FormId form = kNoForm;             ///< The clause that called it, of the program or the top.
  std::span<const Value> arguments;  ///< As bound then; none: an unbound parameter.
  std::span<const Value> variables;  ///< All its variables, the parameters first.
  const PathSkill* caller = nullptr;
};

/// What the agent should do: the calls of an :action skill, all their variables bound.
struct Act {
  std::uint32_t skill = kNoSkill;
  std::span<const Value> arguments;
  std::span<const ActCall> calls;
  const PathSkill* path = nullptr;  ///< The :action skill, then its callers; null: of stopped acts.
  bool started = false;             ///< It was not among the acts of the last cycle.
};

/// The skills that led to an act, the outermost first; `path` is overwritten.
void GetPath(const Act& act, std::vector<const PathSkill*>& path);

/// Something went wrong in a cycle; the clause at `form` was False.
struct Fault {
  FormId form = kNoForm;
  bool in_top = false;  ///< `form` is of the top call, not of the program.
  std::string message;
  std::vector<std::string> skills;  ///< That were being asked, the innermost first.
};

/// What one cycle came to; valid until the next.
struct CycleResult {
  std::span<const Act> acts;      ///< To be done now.
  std::span<const Act> stopped;   ///< Acts of the last cycle that are not among these.
  std::size_t environments = 0;   ///< Ways in which the top call is True.
  std::span<const Value> values;  ///< Of the variables of the top call, for each environment.
  std::span<const Fault> faults;  ///< The first few.
  std::size_t fault_count = 0;
  std::uint64_t clauses = 0;  ///< Evaluated.
  std::uint32_t depth = 0;    ///< Of the skills that called each other.
  LimitHit limit = LimitHit::kNone;
  bool is_whole = true;     ///< Not ended by the first act, by a limit or by a fault.
  bool is_aborted = false;  ///< By a fault, with kAbortCycle and kStop: no acts, not True.
};

class EnvironmentSink;

/// Runs a program, one cycle after the other. Within a cycle nothing is allocated once memory has
/// grown to what the program needs, no clock is read, and nothing escapes: a mistake makes its
/// clause False and is reported as a fault. A cycle is a function of the program, short-term
/// memory, the states of sequences and the answers of the host. Thread rule: one thread at a time.
/// Source: Shapiro and Langley, Controlling Physical Agents Through Reactive Logic Programming
/// (Agents'99), section 3.
class Interpreter {
 public:
  /// `program` has no errors; it, `host` and `names` outlive the interpreter.
  Interpreter(const Program& program, Host& host, NamePool& names, const RunOptions& options);
  ~Interpreter();
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  /// What the program calls and the host lacks. With errors, Cycle must not be called.
  const Findings& findings() const;
  /// Reads a top call, `(CollideWithCar car54)`, and gives it a number. With new errors in
  /// `findings` there is no such number.
  std::size_t AddTop(std::string text, Findings& findings);
  /// The top call that the program names; kNoTop when it names none.
  std::size_t AddTop(Findings& findings);
  /// A conjunction that the program says is never True, by its number in Program::nevers.
  std::size_t AddNever(std::size_t index, Findings& findings);
  /// The names of the variables of a top call, as they stand in CycleResult::values.
  std::span<const std::string> TopVariables(std::size_t top) const;

  /// What the clauses of a top call, `form` of its events and faults, stand in.
  const SourceTree& TopSource(std::size_t top) const;
  /// The call as it was written.
  std::string TopText(std::size_t top) const;

  static constexpr std::size_t kNoTop = static_cast<std::size_t>(-1);
  /// Evaluates a top call once; kNoTop: the program is not called in this cycle. Within the limits
  /// of the options, unless others are given.
  const CycleResult& Cycle(std::size_t top);
  const CycleResult& Cycle(std::size_t top, const CycleLimits& limits);
  /// Who is told what happens in the cycles to come; null: nobody, which costs nothing.
  void SetSink(EventSink* sink);
  /// What gives a value to the skills without a :value; null: nothing.
  void SetValues(ValueSource* values);
  /// Number of the last cycle; the first is 1.
  std::uint64_t cycle() const;

  /// A conjunction that the host may ask while a cycle runs: the :requires of `query`, whose
  /// clauses have no places.
  std::size_t AddQuery(Skill query);
  /// Gives the values of the query's variables, each distinct environment once, as memory is now.
  /// To be called from Host::Call alone. Throws when host functions ask each other without end.
  void Ask(std::size_t query, EnvironmentSink& sink);

  /// Evaluates a top call once more, as the cycle of the last number, and tells a sink of it.
  /// Memory and sequences are as they were afterwards; paths of acts are not.
  void Replay(std::size_t top, const CycleLimits& limits, EventSink& sink);

  /// Goes on where another interpreter is, which is of no use then: with its memory, to which this
  /// program's initial facts from `first_fact` on are added, its acts, and the states of the
  /// sequences that are the same in both programs.
  void TakeOver(Interpreter& other, std::size_t first_fact);

  /// Short-term memory, for the host to write between cycles.
  FactStore& memory();
  /// States of sequences that are kept.
  std::size_t sequence_states() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_INTERPRETER_H_
