// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/progress.h"
#include "apps/latchwork/run_agent.h"
#include "apps/latchwork/settings.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/plugin/registry.h"
#include "reasoners/icarus/learning/comparison.h"

namespace latchwork::app {
namespace {

struct Settings {
  std::filesystem::path agent;
  std::string layer;
  std::filesystem::path values = "learned.values";
  std::string measure = "reward";
  std::uint64_t episodes = 100;
  std::uint64_t trials = 30;
  std::uint64_t seed = 1;
  std::vector<std::string> settings;
  std::vector<std::string> training;
  bool fresh = false;
};

/// The seeds of episodes and of trials do not meet.
constexpr std::uint64_t kFirstEpisode = 1'000'000;

class Trainer {
 public:
  Trainer(const Settings& settings, const Context& context)
      : settings_(settings),
        registry_(plugin::MakeSearchPath(context.plugin_folders, context.executable)) {}

  /// False: an episode could not run.
  bool Train() {
    Progress progress("training", false);
    for (std::uint64_t i = 0; i < settings_.episodes; ++i) {
      const std::uint64_t seed = kFirstEpisode + settings_.seed + i;
      RunRequest request = Request(seed, settings_.training);
      Add(request, "acts", "value");
      Add(request, "learn", "true");
      Add(request, "values", Values());
      Add(request, "exploration_seed", std::to_string(seed));
      if (!Run(request)) return false;
      progress.Update(i + 1, settings_.episodes);
    }
    return true;
  }

  /// The measure in each trial, with the values that were learned or without.
  std::optional<std::vector<double>> Try(bool learned) {
    Progress progress(learned ? "learned" : "unlearned", false);
    std::vector<double> measures;
    for (std::uint64_t i = 0; i < settings_.trials; ++i) {
      RunRequest request = Request(settings_.seed + i, settings_.settings);
      if (learned) {
        Add(request, "acts", "value");
        Add(request, "values", Values());
      }
      const std::optional<double> measure = Run(request);
      if (!measure) return std::nullopt;
      measures.push_back(*measure);
      progress.Update(i + 1, settings_.trials);
    }
    return measures;
  }

  int exit_code() const { return exit_code_; }

 private:
  std::string Values() const { return std::filesystem::absolute(settings_.values).string(); }

  RunRequest Request(std::uint64_t seed, const std::vector<std::string>& settings) const {
    RunRequest request;
    request.agent_file = settings_.agent;
    request.seed = seed;
    request.overrides = ParseSettings(settings);
    return request;
  }

  void Add(RunRequest& request, const std::string& name, const std::string& value) const {
    request.overrides.push_back({settings_.layer + ".reasoner", name, value});
  }

  std::optional<double> Run(const RunRequest& request) {
    const FinishedRun run =
        RunAgent(request, registry_, [](std::uint64_t, std::uint64_t) { return true; });
    if (!run.began) {
      fmt::print(stderr, "{}", run.errors);
      exit_code_ = run.exit_code;
      return std::nullopt;
    }
    const auto& measures = run.result.measures;
    const auto found = std::find_if(measures.begin(), measures.end(), [&](const auto& measure) {
      return measure.first == settings_.measure;
    });
    if (found != measures.end()) return found->second;
    fmt::print(stderr, "error: the world has no measure '{}'\n", settings_.measure);
    exit_code_ = kUsage;
    return std::nullopt;
  }

  const Settings& settings_;
  plugin::Registry registry_;
  int exit_code_ = kDone;
};

double Mean(const std::vector<double>& numbers) {
  const double sum = std::accumulate(numbers.begin(), numbers.end(), 0.0);
  return numbers.empty() ? 0 : sum / static_cast<double>(numbers.size());
}

/// Whether the learned choice is the better one beyond doubt.
bool Report(const Settings& settings, const std::vector<double>& learned,
            const std::vector<double>& unlearned) {
  std::vector<double> gains;
  std::size_t better = 0;
  for (std::size_t i = 0; i < learned.size(); ++i) {
    gains.push_back(learned[i] - unlearned[i]);
    if (gains.back() > 0) ++better;
  }
  const icarus::Interval gain = icarus::BootstrapInterval(gains, settings.seed);
  fmt::print("{} over {} trials, after {} episodes\n", settings.measure, settings.trials,
             settings.episodes);
  fmt::print("  unlearned  {:.3f}\n  learned    {:.3f}\n", Mean(unlearned), Mean(learned));
  fmt::print("  gain       {:.3f}, 95 % interval {:.3f} to {:.3f}; better in {} of {} trials\n",
             gain.mean, gain.low, gain.high, better, learned.size());
  return gain.low > 0;
}

int Learn(const Settings& settings, const Context& context) {
  std::error_code error;
  if (settings.fresh) std::filesystem::remove(settings.values, error);
  Trainer trainer(settings, context);
  if (!trainer.Train()) return trainer.exit_code();
  const std::optional<std::vector<double>> learned = trainer.Try(true);
  if (!learned) return trainer.exit_code();
  const std::optional<std::vector<double>> unlearned = trainer.Try(false);
  if (!unlearned) return trainer.exit_code();
  return Report(settings, *learned, *unlearned) ? kDone : kGoalNotReached;
}

void AddOptions(CLI::App& command, Settings& settings) {
  command.add_option("AGENT", settings.agent, "Agent file (XML)")->required();
  command.add_option("--layer", settings.layer, "The layer that learns; its reasoner is icarus")
      ->required();
  command.add_option("--values", settings.values,
                     "File of values: to begin with, if it is there, and what was learned");
  command.add_flag("--fresh", settings.fresh, "Forget what the file of values holds");
  command.add_option("--episodes", settings.episodes, "Runs to learn from");
  command.add_option("--trials", settings.trials, "Runs to compare, each with and without values")
      ->check(WholeNumber(1));
  command.add_option("--measure", settings.measure, "The measure of the world that is compared");
  command.add_option("--seed", settings.seed, "Of the first trial");
  command.add_option("--set", settings.settings, "PART.NAME=VALUE, in the trials")
      ->allow_extra_args(false);
  command.add_option("--train", settings.training, "PART.NAME=VALUE, in the episodes")
      ->allow_extra_args(false);
}

}  // namespace

void AddIcarusLearn(CLI::App& icarus, Context& context) {
  CLI::App* command = icarus.add_subcommand(
      "learn",
      "Learn values of skills in an agent's world, and compare the choice by value with the "
      "choice without; exit with 1 unless its interval is above 0");
  const auto settings = std::make_shared<Settings>();
  AddOptions(*command, *settings);
  command->callback([settings, &context] { context.exit_code = Learn(*settings, context); });
}

}  // namespace latchwork::app
