// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "apps/compare/dispatch/slurm_scripts.h"
#include "apps/compare/experiment/check_agents.h"
#include "apps/compare/folder/result_folder.h"
#include "apps/compare/runs/run_queue.h"
#include "apps/compare/statistics/sample_size.h"
#include "apps/latchwork/command.h"
#include "apps/latchwork/interruption.h"
#include "apps/latchwork/progress.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::app {
namespace {

using compare::Experiment;
using compare::PlannedRun;
using compare::ResultFolder;
using compare::RunRecord;
using compare::Trouble;

struct CompareOptions {
  std::filesystem::path experiment;
  std::filesystem::path out;
  std::string shard = "1/1";
  std::vector<std::filesystem::path> merge;
  unsigned jobs = 1;
  std::size_t slurm_shards = 0;
  bool slurm = false;
  bool plan = false;
  bool quiet = false;
};

/// A task of an array should last for a minute or more: starting one takes seconds.
constexpr std::size_t kUsualShards = 16;

/// "2/4". Throws CLI::ValidationError for what has not that shape.
compare::Shard ParseShard(const std::string& text) {
  std::size_t index = 0;
  std::size_t count = 0;
  int end = 0;
  const int found = std::sscanf(text.c_str(), "%zu/%zu%n", &index, &count, &end);
  if (found != 2 || text[static_cast<std::size_t>(end)] != '\0' || index < 1 || index > count ||
      count > 10'000) {
    throw CLI::ValidationError("--shard", "'" + text + "' is not INDEX/COUNT, as in 2/4");
  }
  return {index - 1, count};
}

void MakeRuns(const Experiment& experiment, const std::vector<PlannedRun>& missing,
              const CompareOptions& options, const Context& context, std::atomic<bool>& interrupted,
              ResultFolder& folder) {
  Progress progress("runs", options.quiet);
  std::size_t done = 0;
  compare::QueueOptions queue;
  queue.launch = compare::LaunchOf(context.executable, context.plugin_folders);
  queue.limits = experiment.limits;
  queue.jobs = options.jobs;
  queue.on_done = [&](const RunRecord& record) {
    progress.Update(++done, missing.size());
    return folder.Keep(record);
  };
  compare::MakeRuns(missing, queue, interrupted);
}

void ShowPlan(const Experiment& experiment) {
  const std::size_t seeds = experiment.last_seed - experiment.first_seed + 1;
  fmt::print("{}: {} scenarios x {} agents x {} seeds = {} runs\n", experiment.name,
             experiment.scenarios.size(), experiment.contenders.size(), seeds,
             PlanRuns(experiment).size());
  const std::size_t tests = 2 * experiment.scenarios.size() * (experiment.contenders.size() - 1);
  const compare::Demand demand{experiment.level / static_cast<double>(tests), 0.8};
  fmt::print("{} tests share the level {}; with a power of 80 % the strictest of them needs\n",
             tests, experiment.level);
  for (const double lost : {0.1, 0.2, 0.4}) {
    fmt::print("  {:>5} seeds to find an agent that loses {:.0f} of 100 runs that the other wins\n",
               compare::PairsForSuccess(lost, 0, demand), 100 * lost);
  }
  for (const double shift : {0.3, 0.5, 1.0}) {
    fmt::print(
        "  {:>5} seeds to find times that differ by {} standard deviations of the "
        "difference\n",
        compare::PairsForTime(shift, demand), shift);
  }
}

/// All that is wrong with the agents is told before the first run.
bool AreSound(const Experiment& experiment, const std::vector<PlannedRun>& runs,
              const Context& context, const std::atomic<bool>& interrupted) {
  const compare::Launch launch = compare::LaunchOf(context.executable, context.plugin_folders);
  const auto diagnostics = compare::CheckAgents(experiment, runs, launch, interrupted);
  fmt::print(stderr, "{}", logic::Format(diagnostics));
  return diagnostics.empty();
}

int RunExperiment(const Experiment& experiment, const CompareOptions& options,
                  const Context& context) {
  std::atomic<bool>& interrupted = WatchForInterruption();
  ResultFolder folder(experiment, options.out);
  for (const std::filesystem::path& other : options.merge) folder.TakeOver(other);
  if (folder.trouble().kind == Trouble::Kind::kNone) {
    const std::vector<PlannedRun> missing = folder.Missing(ParseShard(options.shard));
    if (!AreSound(experiment, missing, context, interrupted)) return kInvalidInput;
    MakeRuns(experiment, missing, options, context, interrupted, folder);
  }
  const std::string report = folder.WriteResults(
      {compare::LaunchOf(context.executable, context.plugin_folders),
       {fmt::format("latchwork compare {} --out {}", compare::ForShell(options.experiment.string()),
                    compare::ForShell(options.out.string())),
        "latchwork", LATCHWORK_VERSION},
       &interrupted});
  fmt::print(stderr, "{}", folder.trouble().text);
  if (folder.trouble().kind == Trouble::Kind::kInput) return kInvalidInput;
  if (folder.trouble().kind == Trouble::Kind::kWriting) return kInternalError;
  fmt::print("{}", report);
  if (!interrupted) return kDone;
  fmt::print(stderr, "stopped; the same command goes on from here\n");
  return kGoalNotReached;
}

/// A shard keeps all agents of a scenario and a seed together: there are no more than those.
int WriteForSlurm(const Experiment& experiment, const CompareOptions& options,
                  const Context& context) {
  const std::size_t parts =
      experiment.scenarios.size() *
      static_cast<std::size_t>(experiment.last_seed - experiment.first_seed + 1);
  compare::SlurmJob job;
  job.name = experiment.name;
  job.working_folder = std::filesystem::current_path();
  job.launch = compare::LaunchOf(context.executable, context.plugin_folders);
  job.experiment = options.experiment;
  job.out = options.out;
  job.shards = std::min(parts, options.slurm_shards == 0 ? kUsualShards : options.slurm_shards);
  job.jobs = options.jobs;
  job.memory_mb = experiment.limits.memory_mb;
  const std::string problem = WriteSlurmScripts(job);
  if (!problem.empty()) {
    fmt::print(stderr, "{}\n", problem);
    return kInternalError;
  }
  fmt::print("to submit {} shards of {} runs, and their merging:\n  sh {}\n", job.shards,
             PlanRuns(experiment).size(),
             compare::ForShell((job.out / "slurm" / "submit.sh").string()));
  return kDone;
}

int Compare(const CompareOptions& options, const Context& context) {
  const compare::ExperimentFile file = compare::ReadExperiment(options.experiment);
  if (!file.experiment) {
    fmt::print(stderr, "{}", logic::Format(file.diagnostics));
    return kInvalidInput;
  }
  if (options.plan) {
    ShowPlan(*file.experiment);
    return kDone;
  }
  if (options.slurm) {
    const std::atomic<bool>& interrupted = WatchForInterruption();
    const bool sound = AreSound(*file.experiment, PlanRuns(*file.experiment), context, interrupted);
    return sound ? WriteForSlurm(*file.experiment, options, context) : kInvalidInput;
  }
  return RunExperiment(*file.experiment, options, context);
}

constexpr const char* kFooter =
    "An experiment names scenarios (agent files) and agents (changes of them); every agent runs\n"
    "in every scenario with every seed, each run in a process of its own:\n"
    "  <experiment format=\"1\" name=\"office\" seeds=\"1-30\" wall=\"300s\" memory=\"4096MB\">\n"
    "    <scenario name=\"floor\" file=\"../office/scenario1.xml\"/>\n"
    "    <agent name=\"pttp\"/>\n"
    "    <agent name=\"icarus\" fragment=\"../office/icarus.xml\"/>\n"
    "  </experiment>\n"
    "The first agent is compared with each of the others. The folder gets runs.jsonl (all that "
    "was\n"
    "done; the same command goes on from there), results.sqlite (the same bytes whenever and\n"
    "wherever the runs are made), timings.sqlite, runs.csv, report.txt and report.html (opens in\n"
    "a browser, from anywhere).\n\n"
    "Examples:\n"
    "  latchwork compare examples/compare/smoke.xml --out out/smoke -j 2\n"
    "  latchwork compare examples/compare/smoke.xml --plan\n"
    "  latchwork compare office.xml --shard 2/4 --out out/second      (on another machine)\n"
    "  latchwork compare office.xml --slurm 20 --out out/office\n"
    "  latchwork compare office.xml --merge out/first --merge out/second --out out/all\n";

}  // namespace

void AddCompare(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("compare", "Compare agents over scenarios and seeds");
  auto options = std::make_shared<CompareOptions>();
  command->add_option("EXPERIMENT", options->experiment, "Experiment file (XML)")->required();
  command->add_option("--out", options->out, "Folder for the results (default out/EXPERIMENT)");
  command->add_option("-j,--jobs", options->jobs, "Runs at a time")->check(CLI::Range(1, 256));
  command->add_option("--shard", options->shard, "INDEX/COUNT: make only this part of the runs");
  command
      ->add_option("--merge", options->merge,
                   "Take over the runs that are done in this folder; may be repeated")
      ->allow_extra_args(false);
  auto* slurm = command->add_option("--slurm", options->slurm_shards,
                                    "Run nothing: write scripts for SLURM, an array of so many "
                                    "shards (default 16) and a job that merges them");
  slurm->expected(0, 1)->check(CLI::Range(1, 1000));
  command->add_flag("--plan", options->plan, "Say how many runs, and how many seeds are needed");
  command->add_flag("-q,--quiet", options->quiet, "No progress");
  command->footer(kFooter);
  command->callback([options, slurm, &context] {
    options->slurm = slurm->count() > 0;
    ParseShard(options->shard);
    if (options->out.empty()) {
      options->out = std::filesystem::path("out") / options->experiment.stem();
    }
    context.exit_code = Compare(*options, context);
  });
}

}  // namespace latchwork::app
