// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/compare/statistics/bootstrap.h"
#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/icarus_layers.h"
#include "apps/latchwork/progress.h"
#include "apps/latchwork/run_agent.h"
#include "apps/latchwork/settings.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/plugin/registry.h"

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
  std::vector<std::string> reference;
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

  enum class Choice : std::uint8_t { kUnlearned, kLearned, kReference };

  /// The measure in each trial.
  std::optional<std::vector<double>> Try(Choice choice) {
    static constexpr std::array<const char*, 3> kNames = {"unlearned", "learned", "reference"};
    Progress progress(kNames.at(static_cast<std::size_t>(choice)), false);
    std::vector<double> measures;
    for (std::uint64_t i = 0; i < settings_.trials; ++i) {
      RunRequest request =
          Request(settings_.seed + i,
                  choice == Choice::kReference ? settings_.reference : std::vector<std::string>());
      if (choice == Choice::kLearned) {
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

  /// With the settings of all runs, and these, which override them.
  RunRequest Request(std::uint64_t seed, const std::vector<std::string>& settings) const {
    RunRequest request;
    request.agent_file = settings_.agent;
    request.seed = seed;
    request.overrides = ParseSettings(settings_.settings);
    for (const auto& more : ParseSettings(settings)) request.overrides.push_back(more);
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

struct Measures {
  std::vector<double> unlearned;
  std::vector<double> learned;
  std::vector<double> reference;  ///< Empty: there is none.
};

struct Gain {
  compare::Interval interval;
  std::size_t better = 0;  ///< Trials.
};

Gain GainOver(const std::vector<double>& learned, const std::vector<double>& other,
              std::uint64_t seed) {
  Gain gain;
  std::vector<double> gains;
  for (std::size_t i = 0; i < learned.size(); ++i) {
    gains.push_back(learned[i] - other[i]);
    if (gains.back() > 0) ++gain.better;
  }
  gain.interval = compare::BootstrapInterval(gains, seed);
  return gain;
}

void PrintGain(const char* name, const Gain& gain, std::size_t trials) {
  fmt::print("  {:<11}{:.3f}, 95 % interval {:.3f} to {:.3f}; better in {} of {} trials\n", name,
             gain.interval.mean, gain.interval.low, gain.interval.high, gain.better, trials);
}

/// Whether the learned choice is the better one beyond doubt.
bool Report(const Settings& settings, const Measures& measures) {
  const std::vector<double>& learned = measures.learned;
  const Gain gain = GainOver(learned, measures.unlearned, settings.seed);
  fmt::print("{} over {} trials, after {} episodes\n", settings.measure, settings.trials,
             settings.episodes);
  fmt::print("  {:<11}{:.3f}\n  {:<11}{:.3f}\n", "unlearned", Mean(measures.unlearned), "learned",
             Mean(learned));
  PrintGain("gain", gain, learned.size());
  if (!measures.reference.empty()) {
    fmt::print("  {:<11}{:.3f}\n", "reference", Mean(measures.reference));
    PrintGain("  to it", GainOver(measures.reference, learned, settings.seed), learned.size());
  }
  return gain.interval.low > 0;
}

std::optional<Measures> TryAll(const Settings& settings, Trainer& trainer) {
  Measures measures;
  const auto attempt = [&](Trainer::Choice choice, std::vector<double>& into) {
    std::optional<std::vector<double>> tried = trainer.Try(choice);
    if (tried) into = std::move(*tried);
    return tried.has_value();
  };
  const bool tried =
      attempt(Trainer::Choice::kLearned, measures.learned) &&
      attempt(Trainer::Choice::kUnlearned, measures.unlearned) &&
      (settings.reference.empty() || attempt(Trainer::Choice::kReference, measures.reference));
  return tried ? std::optional(std::move(measures)) : std::nullopt;
}

int Learn(const Settings& settings, const Context& context) {
  const int fault = CheckIcarusLayer(settings.agent, settings.layer, context);
  if (fault != kDone) return fault;
  std::error_code error;
  if (settings.fresh) std::filesystem::remove(settings.values, error);
  Trainer trainer(settings, context);
  if (!trainer.Train()) return trainer.exit_code();
  const std::optional<Measures> measures = TryAll(settings, trainer);
  if (!measures) return trainer.exit_code();
  return Report(settings, *measures) ? kDone : kGoalNotReached;
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
  command.add_option("--set", settings.settings, "PART.NAME=VALUE, in all runs")
      ->allow_extra_args(false);
  command.add_option("--train", settings.training, "PART.NAME=VALUE, in the episodes only")
      ->allow_extra_args(false);
  command
      .add_option("--reference", settings.reference,
                  "PART.NAME=VALUE, in trials more of the unlearned choice, to compare with")
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
