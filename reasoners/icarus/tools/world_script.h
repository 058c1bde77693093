// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_WORLD_SCRIPT_H_
#define LATCHWORK_ICARUS_WORLD_SCRIPT_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/machine/fact_store.h"
#include "reasoners/icarus/machine/host.h"
#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/machine/value.h"
#include "reasoners/icarus/tools/answer_table.h"

namespace latchwork::icarus {

/// One `(cycle ...)` of a script.
struct ScriptCycle {
  std::uint32_t line = 0;
  std::vector<ScriptAnswer> answers;
  std::vector<Value> stored;
  /// The first fact that fits the pattern becomes the other; more that fit are forgotten.
  std::vector<std::pair<Value, Value>> updated;
  std::vector<Value> forgotten;    ///< None, also within lists, stands for anything.
  std::optional<std::string> top;  ///< From this cycle on.
  logic::SourcePlace top_place;
  bool idle = false;  ///< The program is not called.
  std::int64_t repeat = 1;
  std::optional<std::vector<std::string>> expected;  ///< Acts, "true", "false", "fault".
};

/// A world as a table: what its sensors answer, what enters and leaves memory, and what the program
/// should do, cycle by cycle. Example:
///     (top (Near car1))
///     (cycle (answer {range-to car1} 3.0) (expect {goforward}))
///     (cycle (answer {range-to car1} 0.5) (expect true))
struct WorldScript {
  std::string top;
  logic::SourcePlace top_place;
  std::deque<std::string> names;
  std::vector<Signature> functions;
  std::vector<ScriptCycle> cycles;
  Arena arena;
};

WorldScript ReadScript(std::string text, std::string file, NamePool& names, Findings& findings);
/// Adds what a text holds to a script. Worlds of the script see it; functions keep their numbers.
void ExtendScript(std::string text, std::string file, NamePool& names, WorldScript& script,
                  Findings& findings);

/// The host that a script describes. Answers, and failures, stay until another answer for the same
/// call replaces them; what is not answered is False.
class ScriptedWorld : public Host {
 public:
  explicit ScriptedWorld(const WorldScript& script) : script_(script) {}

  std::span<const Signature> functions() const override { return script_.functions; }
  std::string Remedy(std::string_view function) const override;
  Value Call(std::size_t function, std::span<const Value> arguments, Arena& arena,
             NamePool& names) override;

  /// Lets a cycle of the script begin.
  void Begin(const ScriptCycle& cycle, FactStore& memory);

 private:
  const WorldScript& script_;
  AnswerTable answers_;
};

/// `{pedal 100}`, or several calls one after the other.
std::string ToString(const Act& act, const NamePool& names);
/// The item of a script that lets a call, {function argument ...}, fail.
std::string FailureItem(const std::string& call, std::string message);
/// What a cycle came to, in the words of `expected`.
std::vector<std::string> Outcome(const CycleResult& result, const NamePool& names);
/// Whether a word of it is an act, of one call or several.
inline bool IsAct(const std::string& word) { return word.starts_with('{'); }
/// All calls of its acts, one after the other.
std::string CallsOf(const std::vector<std::string>& words);
/// Whether it came to what was expected: the same calls (a script does not say which of them are
/// one act), True or not, unless nothing was named, and a fault where one was.
bool Meets(const std::vector<std::string>& outcome, const std::vector<std::string>& expected);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_WORLD_SCRIPT_H_
