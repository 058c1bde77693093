// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/record/replay.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/latchwork/command.h"
#include "apps/latchwork/progress.h"
#include "apps/latchwork/run_agent.h"
#include "apps/latchwork/settings.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/record/journal_header.h"
#include "latchwork/record/journal_reader.h"

namespace latchwork::app {
namespace {

struct ReplayOptions {
  std::filesystem::path journal;
  std::filesystem::path agent;
  std::vector<std::string> settings;
  unsigned threads = 1;
  bool quiet = false;
};

/// The run that the header tells of, with what the command line says instead.
RunRequest MakeRequest(const record::JournalHeader& header, const ReplayOptions& options) {
  RunRequest request;
  request.agent_file =
      options.agent.empty() ? std::filesystem::path(header.agent_file) : options.agent;
  if (!header.scenario.empty()) request.scenario = header.scenario;
  request.seed = header.seed;
  request.ticks = header.max_ticks;
  request.overrides = header.overrides;
  for (config::Override& each : ParseSettings(options.settings)) {
    request.overrides.push_back(std::move(each));
  }
  return request;
}

int Refuse(const record::JournalReader& journal) {
  fmt::print(stderr, "{}", logic::Format(*journal.problem()));
  return kInvalidInput;
}

int ReportPreparation(const PreparedAgent& prepared, const RunRequest& request,
                      const ReplayOptions& options) {
  fmt::print(stderr, "{}", logic::Format(prepared.diagnostics));
  const std::filesystem::path& agent = request.agent_file;
  std::error_code error;
  if (options.agent.empty() && !std::filesystem::exists(agent, error)) {
    fmt::print(stderr, "{}: its run was that of {}{}; say where it is now with --agent\n",
               options.journal.string(), agent.string(),
               agent.is_relative() ? ", seen from the folder in which it was started" : "");
  }
  return prepared.exit_code;
}

int Report(const record::ReplayResult& result, const record::JournalReader& journal) {
  if (result.divergence) {
    fmt::print("{}\n", record::ToString(*result.divergence));
    return kDiverged;
  }
  if (journal.problem()) return Refuse(journal);
  fmt::print("identical: {} ticks{}\n", result.ticks,
             journal.tail_cut() ? ", after which the journal was cut" : "");
  return kDone;
}

int Replay(const ReplayOptions& options, const Context& context) {
  record::JournalReader journal(options.journal);
  if (!journal.header()) return Refuse(journal);
  const RunRequest request = MakeRequest(*journal.header(), options);
  const plugin::Registry registry(
      plugin::MakeSearchPath(context.plugin_folders, context.executable));
  logic::SymbolTable symbols;
  PreparedAgent prepared = PrepareAgent(request, registry, symbols);
  if (!prepared.agent) return ReportPreparation(prepared, request, options);
  const record::JournalHeader now = record::MakeHeader(
      *prepared.agent, registry, request.overrides, request.scenario.value_or(""), request.ticks);
  for (const std::string& difference : record::Differences(*journal.header(), now)) {
    fmt::print(stderr, "note: {}\n", difference);
  }
  Progress progress("replay", options.quiet);
  const record::ReplayResult result = record::Replay(
      journal, *std::move(prepared.agent), options.threads,
      [&](std::uint64_t ticks) { progress.Update(ticks, journal.header()->max_ticks); });
  return Report(result, journal);
}

}  // namespace

void AddReplay(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("replay", "Run a journal's agent again and compare");
  command->footer(
      "Names the first tick, layer and field that differ (exit code 6).\n"
      "Examples:\n"
      "  latchwork replay out/far/run.journal\n"
      "  latchwork replay out/far/run.journal --set avoid.repulsion=0.2");
  const auto options = std::make_shared<ReplayOptions>();
  command->add_option("JOURNAL", options->journal, "As written by run --out")->required();
  command->add_option("--agent", options->agent, "Agent file instead of the journal's");
  command
      ->add_option("--set", options->settings,
                   "PART.NAME=VALUE: shows where another parameter first matters")
      ->allow_extra_args(false);
  command->add_option("--threads", options->threads, "Threads that decide the layers (same result)")
      ->check(CLI::Range(1, 64));
  command->add_flag("-q,--quiet", options->quiet, "No progress");
  command->callback([options, &context] { context.exit_code = Replay(*options, context); });
}

}  // namespace latchwork::app
