// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as an Icarus program and, after a line "----", the world it runs in: every kind of act
// and expansion, within small budgets, twice: a cycle comes to the same each time.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/tools/world_script.h"

namespace latchwork::icarus {
namespace {

constexpr std::string_view kSeparator = "\n----\n";
constexpr std::int64_t kMostRepeats = 3;
constexpr std::size_t kMostCycles = 12;

std::string TextOf(const CycleResult& result, const NamePool& names) {
  std::string text;
  for (const std::string& word : Outcome(result, names)) text += word + ' ';
  for (const Act& act : result.stopped) text += "stop " + ToString(act, names);
  for (const Value& value : result.values) text += ToString(value, names) + ' ';
  for (const Fault& fault : result.faults) text += fault.message + ' ';
  return text + std::to_string(result.clauses) + '\n';
}

/// What the cycles of the script come to.
std::string Run(const Program& program, const std::string& script_text, const RunOptions& options) {
  NamePool names;
  Findings findings;
  const WorldScript script = ReadScript(script_text, "fuzz.world", names, findings);
  if (HasErrors(findings)) return {};
  ScriptedWorld world(script);
  Interpreter interpreter(program, world, names, options);
  if (HasErrors(interpreter.findings())) return {};
  std::string text;
  std::size_t top = Interpreter::kNoTop;
  if (!script.top.empty()) top = interpreter.AddTop(script.top, findings);
  for (std::size_t i = 0; i < std::min(script.cycles.size(), kMostCycles); ++i) {
    const ScriptCycle& cycle = script.cycles[i];
    if (cycle.top) top = interpreter.AddTop(*cycle.top, findings);
    for (std::int64_t n = 0; n < std::min(cycle.repeat, kMostRepeats) && findings.empty(); ++n) {
      world.Begin(cycle, interpreter.memory());
      text += TextOf(interpreter.Cycle(cycle.idle ? Interpreter::kNoTop : top), names);
    }
  }
  return text;
}

void Try(std::string_view text) {
  const std::size_t split = text.find(kSeparator);
  if (split == std::string_view::npos) return;
  const ProgramFile file = ReadProgram(std::string(text.substr(0, split)), "fuzz.icarus");
  if (HasErrors(file.findings)) return;
  const std::string script(text.substr(split + kSeparator.size()));
  RunOptions options;
  options.max_depth = 60;
  options.max_clauses = 3000;
  options.means = 2;
  for (const ActMode acts : {ActMode::kFirst, ActMode::kAll, ActMode::kValue}) {
    options.acts = acts;
    options.expansion =
        static_cast<Expansion>((script.size() + static_cast<std::size_t>(acts)) % 3);
    options.restart = script.size() % 2 == 1;
    const std::string once = Run(file.program, script, options);
    if (Run(file.program, script, options) != once) std::abort();
  }
}

}  // namespace
}  // namespace latchwork::icarus

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  latchwork::icarus::Try({reinterpret_cast<const char*>(data), size});
  return 0;
}
