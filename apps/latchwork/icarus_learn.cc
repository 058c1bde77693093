// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "apps/compare/statistics/bootstrap.h"
#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/icarus_layers.h"
#include "apps/latchwork/icarus_trainer.h"
#include "apps/latchwork/settings.h"

namespace latchwork::app {
namespace {

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
bool Report(const LearnSettings& settings, const Measures& measures) {
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

std::optional<Measures> TryAll(const LearnSettings& settings, IcarusTrainer& trainer) {
  Measures measures;
  const auto attempt = [&](LearnedChoice choice, std::vector<double>& into) {
    std::optional<std::vector<double>> tried = trainer.Try(choice);
    if (tried) into = std::move(*tried);
    return tried.has_value();
  };
  const bool tried =
      attempt(LearnedChoice::kLearned, measures.learned) &&
      attempt(LearnedChoice::kUnlearned, measures.unlearned) &&
      (settings.reference.empty() || attempt(LearnedChoice::kReference, measures.reference));
  return tried ? std::optional(std::move(measures)) : std::nullopt;
}

int Learn(const LearnSettings& settings, const Context& context) {
  const int fault = CheckIcarusLayer(settings.agent, settings.layer, context);
  if (fault != kDone) return fault;
  std::error_code error;
  if (settings.fresh) std::filesystem::remove(settings.values, error);
  IcarusTrainer trainer(settings, context);
  if (!trainer.Train()) return trainer.exit_code();
  const std::optional<Measures> measures = TryAll(settings, trainer);
  if (!measures) return trainer.exit_code();
  return Report(settings, *measures) ? kDone : kGoalNotReached;
}

void AddOptions(CLI::App& command, LearnSettings& settings) {
  command.add_option("AGENT", settings.agent, "Agent file (XML)")->required();
  command.add_option("--layer", settings.layer, "The layer that learns; its reasoner is icarus")
      ->required();
  command.add_option("--values", settings.values,
                     "File of values: to begin with, if it is there, and what was learned");
  command.add_flag("--fresh", settings.fresh, "Forget what the file of values holds");
  command.add_option("--episodes", settings.episodes, "Runs to learn from");
  command.add_option("--validation", settings.validation,
                     "Runs, with seeds of their own, that tell which values are kept: the best of "
                     "those after every so many episodes (--every), or none; 0: the last");
  command.add_option("--every", settings.every, "Episodes between validations")
      ->check(WholeNumber(1));
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
  const auto settings = std::make_shared<LearnSettings>();
  AddOptions(*command, *settings);
  command->callback([settings, &context] { context.exit_code = Learn(*settings, context); });
}

}  // namespace latchwork::app
