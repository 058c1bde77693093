// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_ICARUS_TRAINER_H_
#define LATCHWORK_APPS_LATCHWORK_ICARUS_TRAINER_H_

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/run_agent.h"
#include "latchwork/plugin/registry.h"

namespace latchwork::app {

/// What `latchwork icarus learn` was asked for.
struct LearnSettings {
  std::filesystem::path agent;
  std::string layer;
  std::filesystem::path values = "learned.values";
  std::string measure = "reward";
  std::uint64_t episodes = 100;
  std::uint64_t trials = 30;
  std::uint64_t validation = 0;  ///< Runs; 0: what was learned last is kept.
  std::uint64_t every = 50;      ///< Episodes between validations.
  std::uint64_t seed = 1;
  std::vector<std::string> settings;
  std::vector<std::string> training;
  std::vector<std::string> reference;
  bool fresh = false;
};

enum class LearnedChoice : std::uint8_t { kUnlearned, kLearned, kReference };

/// Runs the episodes in which a layer learns values, and the runs in which they are tried. The
/// seeds of episodes, of validations and of trials do not meet. Thread rule: one thread.
class IcarusTrainer {
 public:
  /// Both outlive this.
  IcarusTrainer(const LearnSettings& settings, const Context& context);

  /// Learns, and leaves in the file of values those that were best in the validations (none, when
  /// the unlearned choice was), else the last ones. False: a run failed, or a file.
  bool Train();
  /// The measure in each trial; nothing: a run failed.
  std::optional<std::vector<double>> Try(LearnedChoice choice);

  /// Of the run that failed.
  int exit_code() const { return exit_code_; }

 private:
  struct Runs {
    const char* name;
    std::uint64_t first_seed;
    std::uint64_t count;
  };

  /// Of the values that were validated.
  struct Best {
    double mean = 0;
    std::optional<std::uint64_t> episodes;  ///< That they were learned from; nothing: none so far.
    std::string values;
  };

  bool Learn(std::uint64_t first, std::uint64_t count);
  bool LearnAndValidate();
  bool Consider(std::uint64_t episodes, LearnedChoice choice, Best& best);
  std::optional<double> Validate(LearnedChoice choice);
  std::optional<std::vector<double>> Measure(const Runs& runs, LearnedChoice choice);
  std::optional<double> Run(const RunRequest& request);
  RunRequest Request(std::uint64_t seed, const std::vector<std::string>& settings) const;
  void Add(RunRequest& request, const std::string& name, const std::string& value) const;
  bool Keep(const std::string& values);
  std::string Values() const;

  const LearnSettings& settings_;
  plugin::Registry registry_;
  int exit_code_ = kDone;
};

/// 0: of no numbers.
double Mean(const std::vector<double>& numbers);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_ICARUS_TRAINER_H_
