// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/run_plan.h"

#include <string_view>

namespace latchwork::compare {
namespace {

std::vector<std::string> ArgumentsOf(const Scenario& scenario, const Contender& contender,
                                     std::uint64_t seed) {
  std::vector<std::string> arguments = {"run", scenario.file.string(), "--seed",
                                        std::to_string(seed + contender.seed_offset)};
  if (contender.fragment) {
    arguments.emplace_back("--scenario");
    arguments.push_back(contender.fragment->string());
  }
  for (const std::string& setting : contender.settings) {
    arguments.emplace_back("--set");
    arguments.push_back(setting);
  }
  return arguments;
}

}  // namespace

std::string ForShell(const std::string& word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./=:,+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

std::string CommandOf(const PlannedRun& run) {
  std::string command = "latchwork";
  for (const std::string& word : run.arguments) command += ' ' + ForShell(word);
  return command;
}

std::vector<PlannedRun> PlanRuns(const Experiment& experiment, const Shard& shard) {
  std::vector<PlannedRun> runs;
  std::size_t number = 0;
  for (std::uint64_t seed = experiment.first_seed; seed <= experiment.last_seed; ++seed) {
    for (const Scenario& scenario : experiment.scenarios) {
      if (number++ % shard.count != shard.index) continue;
      for (const Contender& contender : experiment.contenders) {
        runs.push_back(
            {{scenario.name, contender.name, seed}, ArgumentsOf(scenario, contender, seed)});
      }
    }
  }
  return runs;
}

}  // namespace latchwork::compare
