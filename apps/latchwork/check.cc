// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "apps/latchwork/command.h"
#include "latchwork/config/agent.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/schedule/agent.h"

namespace latchwork::app {
namespace {

struct CheckOptions {
  std::vector<std::filesystem::path> agents;
  bool json = false;
};

int ExitCodeOf(const config::AgentFile& file) {
  if (file.plugin_failure) return kPluginFailure;
  return file.agent ? kDone : kInvalidInput;
}

nlohmann::ordered_json ToJson(const logic::Diagnostic& diagnostic) {
  return {{"file", diagnostic.place.file},
          {"line", diagnostic.place.line},
          {"column", diagnostic.place.column},
          {"message", diagnostic.message},
          {"hint", diagnostic.hint}};
}

void PrintSummary(const std::filesystem::path& path, const config::AgentDescription& agent) {
  fmt::print("{}: ok: {} layers, {} wires, {} inhibitions, {} events; {} ticks of {} us\n",
             path.string(), agent.layers.size(), agent.wires.size(), agent.inhibitions.size(),
             agent.events.size(), agent.max_ticks, agent.tick_us);
}

void PrintErrors(const std::filesystem::path& path, const logic::Diagnostics& diagnostics) {
  fmt::print(stderr, "{}{}: {} error{}\n", logic::Format(diagnostics), path.string(),
             diagnostics.size(), diagnostics.size() == 1 ? "" : "s");
}

int CheckAll(const CheckOptions& options, const config::Catalog& catalog) {
  int exit_code = kDone;
  auto list = nlohmann::ordered_json::array();
  for (const std::filesystem::path& path : options.agents) {
    logic::SymbolTable symbols;
    const config::AgentFile file = config::ReadAgentFile(path, catalog, {}, symbols);
    exit_code = std::max(exit_code, ExitCodeOf(file));
    if (options.json) {
      for (const auto& diagnostic : file.diagnostics) list.push_back(ToJson(diagnostic));
    } else if (file.agent) {
      PrintSummary(path, *file.agent);
    } else {
      PrintErrors(path, file.diagnostics);
    }
  }
  if (options.json) {
    constexpr auto kReplaceBadText = nlohmann::ordered_json::error_handler_t::replace;
    fmt::print("{}\n", list.dump(2, ' ', false, kReplaceBadText));
  }
  return exit_code;
}

}  // namespace

void AddCheck(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("check", "Check agent files without running them");
  const auto options = std::make_shared<CheckOptions>();
  command->add_option("AGENT", options->agents, "Agent files (XML)")->required();
  command->add_flag("--json", options->json, "Print the errors as a JSON list");
  command->callback([options, &context] {
    const plugin::Registry registry(
        plugin::MakeSearchPath(context.plugin_folders, context.executable));
    context.exit_code = CheckAll(*options, schedule::MakeCatalog(registry));
  });
}

}  // namespace latchwork::app
