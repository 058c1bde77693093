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
#include "apps/latchwork/run_agent.h"
#include "apps/latchwork/settings.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/plugin/registry.h"

namespace latchwork::app {
namespace {

struct CheckOptions {
  std::vector<std::filesystem::path> agents;
  std::string scenario;
  std::vector<std::string> settings;
  bool json = false;
};

nlohmann::ordered_json ToJson(const logic::Diagnostic& diagnostic) {
  return {{"file", diagnostic.place.file},     {"line", diagnostic.place.line},
          {"column", diagnostic.place.column}, {"message", diagnostic.message},
          {"hint", diagnostic.hint},           {"excerpt", diagnostic.excerpt}};
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

/// Everything but the run itself: theories are read by their reasoners, the world takes its map,
/// start and goal.
int CheckAll(const CheckOptions& options, const plugin::Registry& registry) {
  RunRequest request;
  if (!options.scenario.empty()) request.scenario = options.scenario;
  request.overrides = ParseSettings(options.settings);
  int exit_code = kDone;
  auto list = nlohmann::ordered_json::array();
  for (const std::filesystem::path& path : options.agents) {
    logic::SymbolTable symbols;
    request.agent_file = path;
    const PreparedAgent prepared = PrepareAgent(request, registry, symbols);
    exit_code = std::max(exit_code, prepared.exit_code);
    if (options.json) {
      for (const auto& diagnostic : prepared.diagnostics) list.push_back(ToJson(diagnostic));
    } else if (prepared.agent) {
      PrintSummary(path, prepared.agent->description);
    } else {
      PrintErrors(path, prepared.diagnostics);
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
  command->footer(
      "Reads agents, theories, programs and maps as 'run' does, and tells every mistake with its "
      "place.\nExamples:\n"
      "  latchwork check examples/office/*.xml\n"
      "  latchwork check examples/office/scenario1.xml --scenario examples/office/icarus.xml");
  const auto options = std::make_shared<CheckOptions>();
  command->add_option("AGENT", options->agents, "Agent files (XML)")->required();
  command->add_option("--scenario", options->scenario,
                      "Fragment file whose overrides and events come on top");
  command->add_option("--set", options->settings, "PART.NAME=VALUE, as in world.people=4")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "Print the errors as a JSON list");
  command->callback([options, &context] {
    const plugin::Registry registry(
        plugin::MakeSearchPath(context.plugin_folders, context.executable));
    context.exit_code = CheckAll(*options, registry);
  });
}

}  // namespace latchwork::app
