// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/ompl_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace latchwork::compare {
namespace {

using Runs = std::vector<const RunRecord*>;

constexpr std::array kOutcomes = {Outcome::kReached, Outcome::kCollision, Outcome::kNotReached,
                                  Outcome::kFailed,  Outcome::kTimedOut,  Outcome::kCrashed};

/// A column: its name and type, and the value of a run; "nan" is left open.
struct Property {
  std::string name;
  std::string (*value)(const RunRecord& run, double limit_s);
};

std::string Solved(const RunRecord& run, double) {
  return run.outcome == Outcome::kReached ? "1" : "0";
}

std::string Status(const RunRecord& run, double) {
  return fmt::format("{}", std::ranges::find(kOutcomes, run.outcome) - kOutcomes.begin());
}

/// What fails takes as long as it might have, as where planners run out of time.
std::string Time(const RunRecord& run, double limit_s) {
  if (run.outcome == Outcome::kReached) return fmt::format("{}", run.time_s);
  return limit_s > 0 ? fmt::format("{}", limit_s) : "nan";
}

std::string Length(const RunRecord& run, double) {
  return run.outcome == Outcome::kReached ? fmt::format("{}", run.distance_m) : "nan";
}

std::string Decisions(const RunRecord& run, double) {
  std::uint64_t decisions = 0;
  for (const LayerRecord& layer : run.layers) decisions += layer.decisions;
  return fmt::format("{}", decisions);
}

std::string Inferences(const RunRecord& run, double) {
  double inferences = 0;
  for (const LayerRecord& layer : run.layers) {
    inferences += layer.inferences * static_cast<double>(layer.decisions);
  }
  return fmt::format("{}", inferences);
}

const std::array<Property, 9> kProperties = {
    {{"time REAL", Time},
     {"solved BOOLEAN", Solved},
     {"status ENUM", Status},
     {"solution length REAL", Length},
     {"collisions INTEGER",
      [](const RunRecord& run, double) { return fmt::format("{}", run.collisions); }},
     {"decisions INTEGER", Decisions},
     {"inferences REAL", Inferences},
     {"processor time REAL",
      [](const RunRecord& run, double) { return fmt::format("{}", run.cpu_s); }},
     {"seed INTEGER",
      [](const RunRecord& run, double) { return fmt::format("{}", run.key.seed); }}}};

std::string Head(const ReportInput& input, const std::string& scenario, double limit_s) {
  const Experiment& experiment = input.experiment;
  double seconds = 0;
  for (const auto& [key, run] : input.records) {
    if (key.scenario != scenario) continue;
    seconds += run.cpu_s;
  }
  return fmt::format(
      "{} version {}\nExperiment {}-{}\nRunning on unknown\nStarting at unknown\n<<<|\n{}\n|>>>\n"
      "{} is the random seed\n{} seconds per run\n{} MB per run\n{} runs per planner\n"
      "{} seconds spent to collect the data\n",
      input.making.program, input.making.version, experiment.name, scenario, input.making.command,
      experiment.first_seed, limit_s, experiment.limits.memory_mb,
      experiment.last_seed - experiment.first_seed + 1, seconds);
}

std::string Settings(const Contender& contender) {
  std::string text = fmt::format(
      "{} common properties\n",
      contender.settings.size() + static_cast<std::size_t>(contender.fragment.has_value()));
  if (contender.fragment) text += fmt::format("fragment = {}\n", contender.fragment->string());
  for (const std::string& setting : contender.settings) text += fmt::format("set = {}\n", setting);
  return text;
}

std::string Planner(const Contender& contender, const Runs& runs, double limit_s) {
  std::string text = contender.name + '\n' + Settings(contender);
  text += fmt::format("{} properties for each run\n", kProperties.size());
  for (const Property& property : kProperties) text += property.name + '\n';
  text += fmt::format("{} runs\n", runs.size());
  for (const RunRecord* run : runs) {
    for (const Property& property : kProperties) text += property.value(*run, limit_s) + "; ";
    text += '\n';
  }
  return text + ".\n";
}

}  // namespace

std::string ToOmplLog(const ReportInput& input, const std::string& scenario) {
  const double limit_s = LimitOf(input.records, scenario);
  std::string log = Head(input, scenario, limit_s) + "1 enum type\nstatus";
  for (const Outcome outcome : kOutcomes) log += fmt::format("|{}", Name(outcome));
  log += fmt::format("\n{} planners\n", input.experiment.contenders.size());
  for (const Contender& contender : input.experiment.contenders) {
    log += Planner(contender, RunsOf(input, scenario, contender.name), limit_s);
  }
  return log;
}

}  // namespace latchwork::compare
