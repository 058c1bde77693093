// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "apps/latchwork/command.h"
#include "apps/latchwork/interruption.h"
#include "apps/latchwork/progress.h"
#include "apps/latchwork/run_agent.h"
#include "apps/latchwork/run_json.h"
#include "apps/latchwork/run_table.h"
#include "apps/latchwork/settings.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/plugin/registry.h"

namespace latchwork::app {
namespace {

struct RunOptions {
  std::vector<std::filesystem::path> agents;
  std::string scenario;
  std::uint64_t seed = 1;
  std::string seeds;
  std::optional<std::uint64_t> ticks;
  std::filesystem::path out;
  std::vector<std::string> settings;
  unsigned threads = 1;
  unsigned jobs = 1;
  bool json = false;
  bool quiet = false;
};

std::optional<std::uint64_t> ParseNumber(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// "7" or "1-30".
std::optional<std::pair<std::uint64_t, std::uint64_t>> ParseSeeds(std::string_view text) {
  const std::size_t dash = text.find('-');
  const std::optional<std::uint64_t> first = ParseNumber(text.substr(0, dash));
  const std::optional<std::uint64_t> last =
      dash == std::string_view::npos ? first : ParseNumber(text.substr(dash + 1));
  if (!first || !last || *last < *first) return std::nullopt;
  return std::pair(*first, *last);
}

constexpr std::uint64_t kMostRuns = 1'000'000;

void RefuseTooMany(const RunOptions& options, std::pair<std::uint64_t, std::uint64_t> seeds) {
  const std::uint64_t most = kMostRuns / options.agents.size();
  if (seeds.second - seeds.first < most) return;
  throw CLI::ValidationError(
      "--seeds", fmt::format("{} asks for more than {} runs", options.seeds, kMostRuns));
}

/// The results of two agent files would go to one folder.
void RefuseSameNames(const RunOptions& options) {
  std::set<std::string> names;
  for (const std::filesystem::path& agent : options.agents) {
    if (names.insert(agent.stem().string()).second || options.out.empty()) continue;
    throw CLI::ValidationError(
        "--out", fmt::format("two agent files are called '{}'; run them one at a time, each into "
                             "its own folder",
                             agent.stem().string()));
  }
}

/// Throws CLI::ValidationError for values that have not their documented shape.
std::vector<RunRequest> MakeRequests(const RunOptions& options) {
  RunRequest request;
  request.ticks = options.ticks;
  request.threads = options.threads;
  if (!options.scenario.empty()) request.scenario = options.scenario;
  request.overrides = ParseSettings(options.settings);
  auto seeds = std::optional(std::pair(options.seed, options.seed));
  if (!options.seeds.empty()) seeds = ParseSeeds(options.seeds);
  if (!seeds) {
    throw CLI::ValidationError("--seeds", "'" + options.seeds + "' is not FIRST-LAST, as in 1-30");
  }
  RefuseTooMany(options, *seeds);
  RefuseSameNames(options);
  const bool single = options.agents.size() == 1 && seeds->first == seeds->second;
  std::vector<RunRequest> requests;
  for (const std::filesystem::path& agent : options.agents) {
    for (std::uint64_t offset = 0; offset <= seeds->second - seeds->first; ++offset) {
      request.agent_file = agent;
      request.seed = seeds->first + offset;
      if (!options.out.empty()) {
        request.out =
            single ? options.out
                   : options.out / fmt::format("{}-seed{}", agent.stem().string(), request.seed);
      }
      requests.push_back(request);
    }
  }
  return requests;
}

/// Runs them all, `jobs` at a time; results come in the order of the requests. When it is
/// interrupted, what runs is stopped and what is left is not begun.
std::vector<FinishedRun> RunAll(const std::vector<RunRequest>& requests,
                                const plugin::Registry& registry, const RunOptions& options) {
  std::vector<FinishedRun> finished(requests.size());
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::mutex mutex;
  const std::atomic<bool>& interrupted = WatchForInterruption();
  Progress progress(requests.size() == 1 ? "run" : "runs", options.quiet);
  const auto work = [&] {
    for (std::size_t i = next++; i < requests.size() && !interrupted; i = next++) {
      FinishedRun run =
          RunAgent(requests[i], registry, [&](std::uint64_t tick, std::uint64_t total) {
            if (requests.size() == 1) progress.Update(tick, total);
            return !interrupted;
          });
      const std::scoped_lock lock(mutex);
      finished[i] = std::move(run);
      if (requests.size() > 1) progress.Update(++done, requests.size());
    }
  };
  std::vector<std::jthread> workers;
  for (unsigned job = 1; job < options.jobs; ++job) workers.emplace_back(work);
  work();
  workers.clear();
  std::erase_if(finished, [](const FinishedRun& run) { return !run.began && run.errors.empty(); });
  if (finished.size() < requests.size()) {
    fmt::print(stderr, "stopped: {} of {} runs were begun\n", finished.size(), requests.size());
  }
  return finished;
}

/// The gravest exit code: what could not run comes before what ran and did not reach its goal.
int ExitCodeOf(const std::vector<FinishedRun>& runs) {
  if (runs.empty()) return kGoalNotReached;
  return std::max_element(
             runs.begin(), runs.end(),
             [](const FinishedRun& a, const FinishedRun& b) { return a.exit_code < b.exit_code; })
      ->exit_code;
}

void PrintErrors(const std::vector<FinishedRun>& runs) {
  std::vector<std::string> told;
  for (const FinishedRun& run : runs) {
    if (run.errors.empty() || std::find(told.begin(), told.end(), run.errors) != told.end()) {
      continue;
    }
    std::fputs(run.errors.c_str(), stderr);
    told.push_back(run.errors);
  }
}

void PrintSingle(const FinishedRun& run) {
  if (!run.began) return;
  fmt::print("{}\n{}", OutcomeText(run), LayerTable(run.result));
  for (const std::filesystem::path& file : run.written) fmt::print("wrote {}\n", file.string());
}

void Print(const std::vector<FinishedRun>& runs, const RunOptions& options) {
  PrintErrors(runs);
  if (options.json) {
    fmt::print("{}\n", ToJson(runs));
  } else if (runs.empty()) {
    return;
  } else if (runs.size() == 1) {
    PrintSingle(runs.front());
  } else {
    fmt::print("{}", ScenarioTable(runs));
    if (const std::string failures = FailureList(runs); !failures.empty()) {
      fmt::print("\n{}", failures);
    }
    if (!options.out.empty()) {
      fmt::print("journals, summaries and pictures: {}\n", options.out.string());
    }
  }
}

void Run(const RunOptions& options, Context& context) {
  const std::vector<RunRequest> requests = MakeRequests(options);
  const plugin::Registry registry(
      plugin::MakeSearchPath(context.plugin_folders, context.executable));
  const std::vector<FinishedRun> runs = RunAll(requests, registry, options);
  Print(runs, options);
  if (context.used) {
    for (const FinishedRun& run : runs) std::ranges::for_each(run.libraries, context.used);
  }
  context.exit_code = ExitCodeOf(runs);
}

void AddOptions(CLI::App& command, RunOptions& options) {
  command.add_option("AGENT", options.agents, "Agent file (XML); several make a table")->required();
  command.add_option("--seed", options.seed, "Of everything random in the world (default 1)")
      ->check(WholeNumber());
  command.add_option("--seeds", options.seeds, "FIRST-LAST: run every seed and print a table")
      ->excludes("--seed");
  command.add_option("--scenario", options.scenario,
                     "Fragment file whose overrides and events come on top");
  command
      .add_option("--ticks", options.ticks,
                  "Stop after so many ticks instead of the agent's duration")
      ->check(WholeNumber(1));
  command
      .add_option("--set", options.settings, "PART.NAME=VALUE: a parameter, as in world.people=4")
      ->allow_extra_args(false);
  command
      .add_option("--out", options.out,
                  "Folder for the journal, the summary and a picture of every floor")
      ->check(NotEmpty());
  command
      .add_option("--threads", options.threads,
                  "Threads that decide the layers of one run (same result)")
      ->check(CLI::Range(1, 64));
  command.add_option("-j,--jobs", options.jobs, "Runs at a time")->check(CLI::Range(1, 256));
  command.add_flag("--json", options.json, "Print the summary as JSON");
  command.add_flag("-q,--quiet", options.quiet, "No progress");
}

}  // namespace

void AddRun(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("run", "Run an agent in its world");
  command->footer(
      "Examples:\n"
      "  latchwork run examples/office/scenario3.xml --out out/far\n"
      "  latchwork run examples/office/scenario1.xml --seeds 1-30 -j 2\n"
      "  latchwork run examples/office/scenario1.xml --set world.people=0 --set "
      "avoid.repulsion=0.2");
  const auto options = std::make_shared<RunOptions>();
  AddOptions(*command, *options);
  command->callback([options, &context] { Run(*options, context); });
}

}  // namespace latchwork::app
