// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/icarus_session.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "apps/latchwork/icarus_command.h"

namespace latchwork::app {

namespace {

using Json = nlohmann::ordered_json;

bool Accept(const std::string& file, const icarus::Findings& findings) {
  if (!icarus::HasErrors(findings)) return true;
  PrintFindings(file, findings);
  return false;
}

std::size_t AddScriptTop(const std::string& text, const logic::SourcePlace& place,
                         icarus::Interpreter& interpreter, icarus::Findings& findings) {
  icarus::Findings own;
  const std::size_t top = interpreter.AddTop(text, own);
  icarus::MoveTo(place, own);
  findings.insert(findings.end(), own.begin(), own.end());
  return top;
}

/// Gives every cycle its top call: the script's, unless the command line names one.
bool AddTops(const IcarusSettings& settings, const std::string& script_name,
             IcarusSession& session) {
  icarus::Findings findings;
  const icarus::WorldScript& script = session.script;
  icarus::Interpreter& interpreter = *session.interpreter;
  std::size_t top = icarus::Interpreter::kNoTop;
  if (!settings.top.empty()) {
    top = interpreter.AddTop(settings.top, findings);
  } else if (!script.top.empty()) {
    top = AddScriptTop(script.top, script.top_place, interpreter, findings);
  } else {
    top = interpreter.AddTop(findings);
  }
  bool named = top != icarus::Interpreter::kNoTop || !settings.top.empty() || !script.top.empty();
  for (const icarus::ScriptCycle& cycle : script.cycles) {
    if (cycle.top) top = AddScriptTop(*cycle.top, cycle.top_place, interpreter, findings);
    named = named || cycle.top.has_value();
    session.tops.push_back(cycle.idle ? icarus::Interpreter::kNoTop : top);
  }
  if (!named) {
    fmt::print(stderr,
               "{}: error: no top call is given\n  hint: write (top (Skill argument ...)) in the "
               "program or in the script, or use --top\n",
               script_name);
  }
  return Accept(settings.top.empty() ? script_name : "top", findings) && named;
}

}  // namespace

void AddIcarusOptions(CLI::App& command, IcarusSettings& settings) {
  icarus::RunOptions& options = settings.options;
  command.add_option("--top", settings.top, "The call to begin with: \"(Skill argument ...)\"");
  command.add_option("--acts", settings.acts, "Acts that leave a skill: first, all or value")
      ->check(CLI::IsMember({"first", "all", "value"}));
  CLI::Option* const expand =
      command.add_option("--expand", settings.expand, "Means that are asked: all, first or best")
          ->check(CLI::IsMember({"all", "first", "best"}));
  command.add_option("--means", options.means, "How many, with --expand first or best")
      ->check(CLI::PositiveNumber)
      ->needs(expand);
  command
      .add_option("--faults", settings.faults,
                  "What a fault does: false (its clause is False), abort-cycle or stop")
      ->check(CLI::IsMember({"false", "abort-cycle", "stop"}));
  command.add_option("--max-depth", options.max_depth, "Skills that may call each other")
      ->check(CLI::Range(1, 1'000'000));
  command.add_option("--max-clauses", options.max_clauses, "Clauses evaluated in one cycle");
  command.add_flag("--restart", options.restart, "A finished sequence starts again");
  command.add_flag("--full", settings.full, "Go on after the first act");
}

void TakeModes(IcarusSettings& settings) {
  icarus::RunOptions& options = settings.options;
  options.lazy = !settings.full;
  if (settings.acts == "all") options.acts = icarus::ActMode::kAll;
  if (settings.acts == "value") options.acts = icarus::ActMode::kValue;
  if (settings.expand == "first") options.expansion = icarus::Expansion::kFirst;
  if (settings.expand == "best") options.expansion = icarus::Expansion::kBest;
  if (settings.faults == "abort-cycle") options.faults = icarus::FaultMode::kAbortCycle;
  if (settings.faults == "stop") options.faults = icarus::FaultMode::kStop;
}

Json OptionsToJson(const IcarusSettings& settings) {
  const icarus::RunOptions& options = settings.options;
  return {{"acts", settings.acts},          {"expand", settings.expand},
          {"means", options.means},         {"faults", settings.faults},
          {"max_depth", options.max_depth}, {"max_clauses", options.max_clauses},
          {"restart", options.restart},     {"full", settings.full}};
}

bool OptionsFromJson(const Json& json, IcarusSettings& settings) {
  try {
    icarus::RunOptions& options = settings.options;
    json.at("acts").get_to(settings.acts);
    json.at("expand").get_to(settings.expand);
    json.at("means").get_to(options.means);
    json.at("faults").get_to(settings.faults);
    json.at("max_depth").get_to(options.max_depth);
    json.at("max_clauses").get_to(options.max_clauses);
    json.at("restart").get_to(options.restart);
    json.at("full").get_to(settings.full);
  } catch (const Json::exception&) {
    return false;
  }
  TakeModes(settings);
  return true;
}

bool OpenSession(const IcarusSettings& settings, IcarusSession& session) {
  std::optional<std::string> script = ReadProgramText(settings.script);
  return script && OpenSession(settings, *std::move(script), settings.script, session);
}

bool OpenSession(const IcarusSettings& settings, std::string script_text,
                 const std::string& script_name, IcarusSession& session) {
  std::optional<std::string> program = ReadProgramText(settings.program);
  if (!program) return false;
  session.program = icarus::ReadProgram(*std::move(program), settings.program);
  icarus::Findings findings;
  session.script = icarus::ReadScript(std::move(script_text), script_name, session.names, findings);
  const bool program_is_good = Accept(settings.program, session.program.findings);
  if (!Accept(script_name, findings) || !program_is_good) return false;
  session.world.emplace(session.script);
  session.interpreter.emplace(session.program.program, *session.world, session.names,
                              settings.options);
  return Accept(settings.program, session.interpreter->findings()) &&
         AddTops(settings, script_name, session);
}

const icarus::CycleResult& RunCycle(IcarusSession& session, std::size_t index) {
  session.world->Begin(session.script.cycles[index], session.interpreter->memory());
  return session.interpreter->Cycle(session.tops[index]);
}

bool IsAsExpected(const IcarusSession& session, std::size_t index,
                  const icarus::CycleResult& result) {
  const auto& expected = session.script.cycles[index].expected;
  return !expected || icarus::Meets(icarus::Outcome(result, session.names), *expected);
}

std::vector<std::string> Texts(std::span<const icarus::Act> acts, const icarus::NamePool& names) {
  std::vector<std::string> texts;
  for (const icarus::Act& act : acts) texts.push_back(icarus::ToString(act, names));
  return texts;
}

std::vector<std::map<std::string, std::string>> TopBindings(const icarus::Interpreter& interpreter,
                                                            const icarus::NamePool& names,
                                                            std::size_t top,
                                                            const icarus::CycleResult& result) {
  std::vector<std::map<std::string, std::string>> all(result.environments);
  if (top == icarus::Interpreter::kNoTop) return all;
  const auto variables = interpreter.TopVariables(top);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < variables.size(); ++j) {
      const icarus::Value& value = result.values[i * variables.size() + j];
      if (!value.is_none()) all[i][variables[j]] = icarus::ToString(value, names);
    }
  }
  return all;
}

std::string CycleLine(const icarus::Interpreter& interpreter, const icarus::NamePool& names,
                      std::size_t top, const icarus::CycleResult& result) {
  const std::vector<std::string> acts = Texts(result.acts, names);
  std::string line = fmt::format("{}:", interpreter.cycle());
  for (const std::string& act : Texts(result.stopped, names)) line += " stop " + act;
  for (std::size_t i = 0; i < acts.size(); ++i) {
    line += (result.acts[i].started ? " start " : " continue ") + acts[i];
  }
  for (const auto& bindings : TopBindings(interpreter, names, top, result)) {
    line += " True";
    for (const auto& [name, value] : bindings) line += ' ' + name + '=' + value;
  }
  if (result.is_aborted) return line + " aborted";
  if (result.acts.empty() && result.environments == 0) {
    line += top == icarus::Interpreter::kNoTop ? " (not called)" : " False";
  }
  return line;
}

std::vector<std::string> FaultTexts(const icarus::Program& program, std::uint64_t cycle,
                                    const icarus::CycleResult& result) {
  std::vector<std::string> texts;
  for (const icarus::Fault& fault : result.faults) {
    std::string place = "top";
    if (!fault.in_top && fault.form != icarus::kNoForm) {
      const logic::SourcePlace at = program.source.Place(fault.form);
      place = fmt::format("{}:{}:{}", at.file, at.line, at.column);
    }
    std::string stack;
    for (const std::string& skill : fault.skills) stack += (stack.empty() ? "" : " < ") + skill;
    texts.push_back(fmt::format("{}: fault in cycle {}: {}{}", place, cycle, fault.message,
                                stack.empty() ? "" : "\n  in " + stack));
  }
  return texts;
}

void PrintFaults(const IcarusSession& session, const icarus::CycleResult& result) {
  const std::uint64_t cycle = session.interpreter->cycle();
  std::fflush(stdout);  // Where both streams end up in one place, the cycle comes first.
  for (const std::string& text : FaultTexts(session.program.program, cycle, result)) {
    fmt::print(stderr, "{}\n", text);
  }
}

}  // namespace latchwork::app
