// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/icarus_trainer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <numeric>
#include <utility>

#include "apps/latchwork/progress.h"
#include "apps/latchwork/settings.h"
#include "latchwork/plugin/plugin_search.h"

namespace latchwork::app {
namespace {

constexpr std::uint64_t kFirstEpisode = 1'000'000;
constexpr std::uint64_t kFirstValidation = 500'000'000;

std::string Contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

double Mean(const std::vector<double>& numbers) {
  const double sum = std::accumulate(numbers.begin(), numbers.end(), 0.0);
  return numbers.empty() ? 0 : sum / static_cast<double>(numbers.size());
}

IcarusTrainer::IcarusTrainer(const LearnSettings& settings, const Context& context)
    : settings_(settings),
      registry_(plugin::MakeSearchPath(context.plugin_folders, context.executable)) {}

bool IcarusTrainer::Train() {
  return settings_.validation > 0 ? LearnAndValidate() : Learn(0, settings_.episodes);
}

bool IcarusTrainer::Learn(std::uint64_t first, std::uint64_t count) {
  Progress progress("training", false);
  for (std::uint64_t i = first; i < first + count; ++i) {
    const std::uint64_t seed = kFirstEpisode + settings_.seed + i;
    RunRequest request = Request(seed, settings_.training);
    Add(request, "acts", "value");
    Add(request, "learn", "true");
    Add(request, "values", Values());
    Add(request, "exploration_seed", std::to_string(seed));
    if (!Run(request)) return false;
    progress.Update(i - first + 1, count);
  }
  return true;
}

bool IcarusTrainer::LearnAndValidate() {
  std::error_code error;
  const bool has_values = std::filesystem::exists(settings_.values, error);
  fmt::print("{} over {} validations\n", settings_.measure, settings_.validation);
  Best best;
  if (!Consider(0, LearnedChoice::kUnlearned, best)) return false;
  if (has_values && !Consider(0, LearnedChoice::kLearned, best)) return false;
  for (std::uint64_t done = 0; done < settings_.episodes;) {
    const std::uint64_t more = std::min(settings_.every, settings_.episodes - done);
    if (!Learn(done, more)) return false;
    done += more;
    if (!Consider(done, LearnedChoice::kLearned, best)) return false;
  }
  fmt::print("kept {}\n", best.values.empty()
                              ? "no values, as none were better"
                              : fmt::format("the values after {} episodes", *best.episodes));
  return Keep(best.values);
}

/// Keeps the values there are, or none for the unlearned choice, if they are the best so far.
bool IcarusTrainer::Consider(std::uint64_t episodes, LearnedChoice choice, Best& best) {
  const auto measures =
      Measure({"validation", kFirstValidation + settings_.seed, settings_.validation}, choice);
  if (!measures) return false;
  const double mean = Mean(*measures);
  const bool is_learned = choice == LearnedChoice::kLearned;
  const std::string name = is_learned ? fmt::format("{} episodes", episodes) : "unlearned";
  fmt::print("  {:<15}{:.3f}\n", name, mean);
  std::fflush(stdout);  // Validations take long.
  if (best.episodes && mean <= best.mean) return true;
  best = {mean, episodes, is_learned ? Contents(settings_.values) : ""};
  return true;
}

bool IcarusTrainer::Keep(const std::string& values) {
  std::ofstream stream(settings_.values, std::ios::binary);
  stream << values;
  stream.close();
  if (stream) return true;
  fmt::print(stderr, "error: {} cannot be written\n", settings_.values.string());
  exit_code_ = kInvalidInput;
  return false;
}

std::optional<std::vector<double>> IcarusTrainer::Try(LearnedChoice choice) {
  static constexpr std::array<const char*, 3> kNames = {"unlearned", "learned", "reference"};
  return Measure({kNames.at(static_cast<std::size_t>(choice)), settings_.seed, settings_.trials},
                 choice);
}

std::optional<std::vector<double>> IcarusTrainer::Measure(const Runs& runs, LearnedChoice choice) {
  Progress progress(runs.name, false);
  const bool is_reference = choice == LearnedChoice::kReference;
  std::vector<double> measures;
  for (std::uint64_t i = 0; i < runs.count; ++i) {
    RunRequest request = Request(runs.first_seed + i,
                                 is_reference ? settings_.reference : std::vector<std::string>());
    if (choice == LearnedChoice::kLearned) {
      Add(request, "acts", "value");
      Add(request, "values", Values());
    }
    const std::optional<double> measure = Run(request);
    if (!measure) return std::nullopt;
    measures.push_back(*measure);
    progress.Update(i + 1, runs.count);
  }
  return measures;
}

std::string IcarusTrainer::Values() const {
  return std::filesystem::absolute(settings_.values).string();
}

/// With the settings of all runs, and these, which override them.
RunRequest IcarusTrainer::Request(std::uint64_t seed,
                                  const std::vector<std::string>& settings) const {
  RunRequest request;
  request.agent_file = settings_.agent;
  request.seed = seed;
  request.overrides = ParseSettings(settings_.settings);
  for (const auto& more : ParseSettings(settings)) request.overrides.push_back(more);
  return request;
}

void IcarusTrainer::Add(RunRequest& request, const std::string& name,
                        const std::string& value) const {
  request.overrides.push_back({settings_.layer + ".reasoner", name, value});
}

std::optional<double> IcarusTrainer::Run(const RunRequest& request) {
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

}  // namespace latchwork::app
