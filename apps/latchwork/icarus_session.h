// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_ICARUS_SESSION_H_
#define LATCHWORK_APPS_LATCHWORK_ICARUS_SESSION_H_

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/tools/world_script.h"

namespace latchwork::app {

/// How a program is to be run: what `run`, `trace` and `repl` have in common.
struct IcarusSettings {
  std::string program;
  std::string script;
  std::string top;
  icarus::RunOptions options;
  std::string acts = "first";
  std::string expand = "all";
  std::string faults = "false";
  bool full = false;
};

/// Adds the options; TakeModes moves what was given into `options`.
void AddIcarusOptions(CLI::App& command, IcarusSettings& settings);
void TakeModes(IcarusSettings& settings);

/// The options as a JSON object, and back; false where it is no such object.
nlohmann::ordered_json OptionsToJson(const IcarusSettings& settings);
bool OptionsFromJson(const nlohmann::ordered_json& json, IcarusSettings& settings);

/// A program in a scripted world, in the order in which its parts are made.
struct IcarusSession {
  icarus::NamePool names;
  icarus::ProgramFile program;
  icarus::WorldScript script;
  std::optional<icarus::ScriptedWorld> world;
  std::optional<icarus::Interpreter> interpreter;
  std::vector<std::size_t> tops;  ///< Of each cycle of the script.
};

/// Reads the files and prepares the first cycle; false with messages when something is wrong.
bool OpenSession(const IcarusSettings& settings, IcarusSession& session);
/// The same with the text of a script; `script_name` is what messages call it.
bool OpenSession(const IcarusSettings& settings, std::string script_text,
                 const std::string& script_name, IcarusSession& session);

/// One cycle of the script.
const icarus::CycleResult& RunCycle(IcarusSession& session, std::size_t index);
/// Whether it came to what the script expects.
bool IsAsExpected(const IcarusSession& session, std::size_t index,
                  const icarus::CycleResult& result);

std::vector<std::string> Texts(std::span<const icarus::Act> acts, const icarus::NamePool& names);
/// `?d=0.5` for each variable of the top call that is bound, one list for each environment.
std::vector<std::map<std::string, std::string>> TopBindings(const icarus::Interpreter& interpreter,
                                                            const icarus::NamePool& names,
                                                            std::size_t top,
                                                            const icarus::CycleResult& result);
/// The acts that stop, start and go on, and in which environments the top call is True.
std::string CycleLine(const icarus::Interpreter& interpreter, const icarus::NamePool& names,
                      std::size_t top, const icarus::CycleResult& result);
/// Each fault with its place and the skills that were being asked.
std::vector<std::string> FaultTexts(const icarus::Program& program, std::uint64_t cycle,
                                    const icarus::CycleResult& result);
/// The faults of a cycle, to standard error.
void PrintFaults(const IcarusSession& session, const icarus::CycleResult& result);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_ICARUS_SESSION_H_
