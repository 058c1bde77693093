// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/run_agent.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include "apps/latchwork/command.h"
#include "apps/latchwork/out_folder.h"
#include "apps/latchwork/run_json.h"
#include "apps/latchwork/trajectory.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/record/journal_writer.h"
#include "latchwork/schedule/agent.h"
#include "latchwork/schedule/lockstep.h"

namespace latchwork::app {
namespace {

constexpr std::string_view kSummaryFile = "summary.json";

/// Keeps the first fault of each layer and kind, all events and the way, and tells how far the run
/// has come.
class RunWatch : public schedule::RunObserver {
 public:
  RunWatch(FinishedRun& run, const TickNotice& notice, std::uint64_t total)
      : run_(run), notice_(notice), total_(total) {}

  bool OnTick(const schedule::TickRecord& record) override {
    for (const schedule::Fault& fault : record.faults) Keep(fault);
    for (const schedule::EventRecord& event : record.events) {
      run_.events.push_back({record.tick, logic::ToString(event.fact), event.problem});
    }
    trajectory_.Add(record.sensors);
    return notice_(record.tick + 1, total_);
  }

  void OnEnd(const schedule::RunResult& /*result*/) override {
    run_.trajectory = trajectory_.ToText();
  }

 private:
  void Keep(const schedule::Fault& fault) {
    const bool known = std::any_of(run_.faults.begin(), run_.faults.end(), [&](const auto& other) {
      return other.layer == fault.layer && other.kind == fault.kind;
    });
    if (!known) run_.faults.push_back(fault);
  }

  FinishedRun& run_;
  const TickNotice& notice_;
  std::uint64_t total_;
  Trajectory trajectory_;
};

int ExitCodeOf(schedule::RunResult::State state) {
  return state == schedule::RunResult::State::kReached ? kDone : kGoalNotReached;
}

/// What was cut short, by a full disk for instance, is told and removed.
void Account(std::filesystem::path file, bool whole, FinishedRun& run) {
  std::error_code error;
  if (whole && std::filesystem::file_size(file, error) > 0 && !error) {
    run.written.push_back(std::move(file));
    return;
  }
  std::filesystem::remove(file, error);
  run.errors += fmt::format("latchwork: cannot write {}\n", file.string());
  run.exit_code = std::max<int>(run.exit_code, kInternalError);
}

void WriteSummary(const std::filesystem::path& file, FinishedRun& run) {
  std::ofstream stream(file, std::ios::binary);
  stream << ToJson({run}) << '\n';
  stream.close();
  Account(file, static_cast<bool>(stream), run);
}

void WriteResults(const RunRequest& request, const sdk::World& world, FinishedRun& run) {
  WriteSummary(request.out / kSummaryFile, run);
  try {
    for (std::filesystem::path& picture : world.Draw(request.out)) {
      Account(std::move(picture), true, run);
    }
  } catch (const std::exception& problem) {
    run.errors += fmt::format("latchwork: the pictures are not complete: {}\n", problem.what());
    run.exit_code = std::max<int>(run.exit_code, kInternalError);
  }
}

/// A summary tells of what the journal beside it holds, never of an earlier run.
void RemoveOldSummary(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::remove(folder / kSummaryFile, error);
}

/// A run without its journal is still a run; what is missing is told.
void CloseJournal(const record::JournalWriter& journal, const std::filesystem::path& file,
                  FinishedRun& run) {
  if (journal.problem().empty()) {
    run.written.push_back(file);
  } else {
    run.errors += fmt::format("latchwork: {}\n", journal.problem());
    run.exit_code = std::max<int>(run.exit_code, kInternalError);
  }
}

std::vector<std::filesystem::path> LibrariesOf(const config::AgentDescription& agent,
                                               const plugin::Registry& registry) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](sdk::PluginKind kind, const std::string& name) {
    for (const plugin::PluginEntry& entry : registry.List()) {
      if (entry.info && entry.info->kind == kind && entry.name == name) files.push_back(entry.file);
    }
  };
  add(sdk::PluginKind::kWorld, agent.world.plugin);
  for (const config::LayerDescription& layer : agent.layers) {
    add(sdk::PluginKind::kLayer, layer.plugin);
    add(sdk::PluginKind::kReasoner, layer.reasoner.plugin);
  }
  return files;
}

}  // namespace

PreparedAgent PrepareAgent(const RunRequest& request, const plugin::Registry& registry,
                           logic::SymbolTable& symbols) {
  std::vector<std::filesystem::path> fragments;
  if (request.scenario) fragments.push_back(*request.scenario);
  config::AgentFile file = config::ReadAgentFile(
      request.agent_file, schedule::MakeCatalog(registry), request.overrides, symbols, fragments);
  if (!file.agent) {
    return {std::nullopt, std::move(file.diagnostics),
            file.plugin_failure ? kPluginFailure : kInvalidInput};
  }
  schedule::AssembledAgent assembled = schedule::AssembleAgent(
      std::move(*file.agent), schedule::MakePartFactory(registry), symbols, request.seed);
  const int problem = assembled.plugin_failure ? kPluginFailure : kInvalidInput;
  const int exit_code = assembled.agent ? kDone : problem;
  return {std::move(assembled.agent), std::move(assembled.diagnostics), exit_code};
}

FinishedRun RunAgent(const RunRequest& request, const plugin::Registry& registry,
                     const TickNotice& notice) {
  FinishedRun run;
  run.request = request;
  logic::SymbolTable symbols;
  auto [agent, diagnostics, exit_code] = PrepareAgent(request, registry, symbols);
  if (!agent) {
    run.errors = logic::Format(diagnostics);
    run.exit_code = exit_code;
    return run;
  }
  std::optional<OutFolder> folder;
  if (!request.out.empty() && !folder.emplace(request.out).problem().empty()) {
    run.errors = fmt::format("latchwork: {}\n", folder->problem());
    run.exit_code = kUsage;
    return run;
  }
  run.agent_name = agent->description.name;
  run.libraries = LibrariesOf(agent->description, registry);
  run.tick_s = static_cast<double>(agent->description.tick_us) / 1e6;
  run.duration_s =
      static_cast<double>(request.ticks.value_or(agent->description.max_ticks)) * run.tick_s;
  for (const auto& layer : agent->description.layers) run.layer_names.push_back(layer.name);
  RunWatch watch(run, notice, request.ticks.value_or(agent->description.max_ticks));
  schedule::LockstepOptions options;
  options.threads = request.threads;
  options.max_ticks = request.ticks;
  options.observers.push_back(&watch);
  const std::filesystem::path journal_file = request.out / "run.journal";
  std::unique_ptr<record::JournalWriter> journal;
  if (folder) {
    RemoveOldSummary(request.out);
    const record::JournalHeader header = record::MakeHeader(
        *agent, registry, request.overrides, request.scenario.value_or(""), request.ticks);
    journal = std::make_unique<record::JournalWriter>(journal_file, header, *agent);
    options.observers.push_back(journal.get());
  }
  const std::shared_ptr<sdk::World> world = agent->world;
  schedule::Lockstep lockstep(std::move(*agent), options);
  run.result = lockstep.Run();
  run.began = true;
  run.exit_code = ExitCodeOf(run.result.state);
  if (journal != nullptr) {
    CloseJournal(*journal, journal_file, run);
    WriteResults(request, *world, run);
  }
  return run;
}

std::string CommandOf(const RunRequest& request) {
  std::string command =
      fmt::format("latchwork run {} --seed {}", request.agent_file.string(), request.seed);
  if (request.scenario) command += fmt::format(" --scenario {}", request.scenario->string());
  if (request.ticks) command += fmt::format(" --ticks {}", *request.ticks);
  for (const config::Override& setting : request.overrides) {
    command += fmt::format(" --set '{}.{}={}'", setting.part, setting.name, setting.value);
  }
  return command;
}

}  // namespace latchwork::app
