// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/latchwork/icarus_command.h"
#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/tools/world_script.h"

namespace latchwork::app {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string program;
  std::string script;
  std::string top;
  icarus::RunOptions options;
  std::string acts = "first";
  std::string expand = "all";
  std::string faults = "false";
  bool full = false;
  bool json = false;
};

/// Everything that one run needs, in the order in which it is made.
struct Session {
  icarus::NamePool names;
  icarus::ProgramFile program;
  icarus::WorldScript script;
  std::optional<icarus::ScriptedWorld> world;
  std::optional<icarus::Interpreter> interpreter;
  std::vector<std::size_t> tops;  ///< Of each cycle of the script.
};

bool Accept(const std::string& file, const icarus::Findings& findings) {
  if (!icarus::HasErrors(findings)) return true;
  PrintFindings(file, findings);
  return false;
}

/// Reads all there is to read; false with a message when something is wrong with it.
bool Prepare(const Settings& settings, Session& session) {
  std::optional<std::string> program = ReadProgramText(settings.program);
  std::optional<std::string> script = ReadProgramText(settings.script);
  if (!program || !script) return false;
  session.program = icarus::ReadProgram(*std::move(program), settings.program);
  icarus::Findings findings;
  session.script = icarus::ReadScript(*std::move(script), settings.script, session.names, findings);
  const bool program_is_good = Accept(settings.program, session.program.findings);
  if (!Accept(settings.script, findings) || !program_is_good) return false;
  session.world.emplace(session.script);
  session.interpreter.emplace(session.program.program, *session.world, session.names,
                              settings.options);
  return Accept(settings.program, session.interpreter->findings());
}

/// Gives every cycle its top call: the script's, unless the command line names one.
bool AddTops(const Settings& settings, Session& session) {
  icarus::Findings findings;
  const std::string& first = settings.top.empty() ? session.script.top : settings.top;
  std::size_t top = first.empty() ? session.interpreter->AddTop(findings)
                                  : session.interpreter->AddTop(first, findings);
  bool named = top != icarus::Interpreter::kNoTop || !first.empty();
  for (const icarus::ScriptCycle& cycle : session.script.cycles) {
    if (cycle.top) top = session.interpreter->AddTop(*cycle.top, findings);
    named = named || cycle.top.has_value();
    session.tops.push_back(cycle.idle ? icarus::Interpreter::kNoTop : top);
  }
  if (!named) {
    fmt::print(stderr,
               "{}: error: no top call is given\n  hint: write (top (Skill argument ...)) in the "
               "program or in the script, or use --top\n",
               settings.script);
  }
  return Accept(settings.script, findings) && named;
}

std::vector<std::string> Texts(std::span<const icarus::Act> acts, const icarus::NamePool& names) {
  std::vector<std::string> texts;
  for (const icarus::Act& act : acts) texts.push_back(icarus::ToString(act, names));
  return texts;
}

/// `?d=0.5` for each variable of the top call that is bound, one list for each environment.
std::vector<std::map<std::string, std::string>> Bindings(const Session& session, std::size_t top,
                                                         const icarus::CycleResult& result) {
  std::vector<std::map<std::string, std::string>> all(result.environments);
  if (top == icarus::Interpreter::kNoTop) return all;
  const auto variables = session.interpreter->TopVariables(top);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < variables.size(); ++j) {
      const icarus::Value& value = result.values[i * variables.size() + j];
      if (!value.is_none()) all[i][variables[j]] = icarus::ToString(value, session.names);
    }
  }
  return all;
}

void PrintText(const Session& session, std::size_t top, const icarus::CycleResult& result) {
  const std::vector<std::string> acts = Texts(result.acts, session.names);
  std::string line;
  for (const std::string& act : Texts(result.stopped, session.names)) line += " stop " + act;
  for (std::size_t i = 0; i < acts.size(); ++i) {
    line += (result.acts[i].started ? " start " : " continue ") + acts[i];
  }
  for (const auto& bindings : Bindings(session, top, result)) {
    line += " True";
    for (const auto& [name, value] : bindings) line += ' ' + name + '=' + value;
  }
  if (result.acts.empty() && result.environments == 0) {
    line += top == icarus::Interpreter::kNoTop ? " (not called)" : " False";
  }
  fmt::print("{}:{}\n", session.interpreter->cycle(), line);
}

void PrintJson(const Session& session, std::size_t top, const icarus::CycleResult& result,
               bool met) {
  Json line = {{"cycle", session.interpreter->cycle()},
               {"acts", Texts(result.acts, session.names)},
               {"stopped", Texts(result.stopped, session.names)},
               {"true", Bindings(session, top, result)},
               {"clauses", result.clauses},
               {"faults", result.fault_count},
               {"expected", met}};
  fmt::print("{}\n", line.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void PrintFaults(const Session& session, const icarus::CycleResult& result) {
  for (const icarus::Fault& fault : result.faults) {
    const icarus::SourceTree& source = session.program.program.source;
    std::string place = "top";
    if (!fault.in_top && fault.form != icarus::kNoForm) {
      const logic::SourcePlace at = source.Place(fault.form);
      place = fmt::format("{}:{}:{}", at.file, at.line, at.column);
    }
    std::string stack;
    for (const std::string& skill : fault.skills) stack += (stack.empty() ? "" : " < ") + skill;
    fmt::print(stderr, "{}: fault in cycle {}: {}{}\n", place, session.interpreter->cycle(),
               fault.message, stack.empty() ? "" : "\n  in " + stack);
  }
}

/// Whether the cycle came to what the script expects.
bool RunCycle(const Settings& settings, Session& session, std::size_t index) {
  const icarus::ScriptCycle& cycle = session.script.cycles[index];
  session.world->Begin(cycle, session.interpreter->memory());
  const icarus::CycleResult& result = session.interpreter->Cycle(session.tops[index]);
  const std::vector<std::string> outcome = icarus::Outcome(result, session.names);
  const bool met = !cycle.expected || icarus::Meets(outcome, *cycle.expected);
  if (settings.json) {
    PrintJson(session, session.tops[index], result, met);
  } else {
    PrintText(session, session.tops[index], result);
  }
  PrintFaults(session, result);
  if (met) return true;
  std::string wanted;
  for (const std::string& word : *cycle.expected) wanted += ' ' + word;
  fmt::print(stderr, "{}:{}: cycle {} is not as expected:{}\n", settings.script, cycle.line,
             session.interpreter->cycle(), wanted);
  return false;
}

int Run(const Settings& settings) {
  const auto session = std::make_unique<Session>();
  if (!Prepare(settings, *session) || !AddTops(settings, *session)) return kInvalidInput;
  std::size_t unmet = 0;
  for (std::size_t i = 0; i < session->script.cycles.size(); ++i) {
    for (std::int64_t n = 0; n < session->script.cycles[i].repeat; ++n) {
      if (!RunCycle(settings, *session, i)) ++unmet;
    }
  }
  return unmet == 0 ? kDone : kGoalNotReached;
}

void TakeModes(Settings& settings) {
  icarus::RunOptions& options = settings.options;
  options.lazy = !settings.full;
  if (settings.acts == "all") options.acts = icarus::ActMode::kAll;
  if (settings.acts == "value") options.acts = icarus::ActMode::kValue;
  if (settings.faults == "abort-cycle") options.faults = icarus::FaultMode::kAbortCycle;
  if (settings.faults == "stop") options.faults = icarus::FaultMode::kStop;
  if (settings.expand == "first") options.expansion = icarus::Expansion::kFirst;
  if (settings.expand == "best") options.expansion = icarus::Expansion::kBest;
}

void AddOptions(CLI::App& command, Settings& settings) {
  icarus::RunOptions& options = settings.options;
  command.add_option("PROGRAM", settings.program, "Program; - is standard input")->required();
  command.add_option("--script", settings.script, "What the world does, cycle by cycle")
      ->required();
  command.add_option("--top", settings.top, "The call to begin with: \"(Skill argument ...)\"");
  command.add_option("--acts", settings.acts, "Acts that leave a skill: first, all or value")
      ->check(CLI::IsMember({"first", "all", "value"}));
  command.add_option("--expand", settings.expand, "Means that are asked: all, first or best")
      ->check(CLI::IsMember({"all", "first", "best"}));
  command
      .add_option("--faults", settings.faults,
                  "What a fault does: false (its clause is False), abort-cycle or stop")
      ->check(CLI::IsMember({"false", "abort-cycle", "stop"}));
  command.add_option("--means", options.means, "How many, with --expand first or best");
  command.add_option("--max-depth", options.max_depth, "Skills that may call each other")
      ->check(CLI::Range(1, 1'000'000));
  command.add_option("--max-clauses", options.max_clauses, "Clauses evaluated in one cycle");
  command.add_flag("--restart", options.restart, "A finished sequence starts again");
  command.add_flag("--full", settings.full, "Go on after the first act");
  command.add_flag("--json", settings.json, "Print one JSON object per cycle");
}

}  // namespace

void AddIcarusRun(CLI::App& icarus, Context& context) {
  CLI::App* command = icarus.add_subcommand(
      "run", "Run a program in a scripted world; exit with 1 when it does not do what is expected");
  const auto settings = std::make_shared<Settings>();
  AddOptions(*command, *settings);
  command->callback([settings, &context] {
    TakeModes(*settings);
    context.exit_code = Run(*settings);
  });
}

}  // namespace latchwork::app
