// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "apps/compare/report/findings.h"
#include "apps/compare/report/verdicts.h"

namespace latchwork::compare {
namespace {

constexpr std::size_t kMostFailures = 20;

std::string InWords(const AgentVerdict& verdict, const std::string& first) {
  std::string text = fmt::format("{} against {}\n", verdict.contender, first);
  if (!verdict.compared) text += fmt::format("  {}\n", kNotCompared);
  for (const Difference& each : verdict.differences) {
    text += fmt::format("  {} in {} ({})\n", each.what, each.scenario, each.figures);
  }
  for (const std::string& each : verdict.not_shown) {
    text += fmt::format("  no difference shown: {}\n", each);
  }
  return text;
}

std::string Outcomes(const Tally& tally) {
  std::string text;
  for (const auto& [outcome, count] : tally.outcomes) {
    if (outcome == Outcome::kReached || count == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, Name(outcome));
  }
  return text.empty() ? "-" : text;
}

std::string Table(const std::vector<Tally>& tallies) {
  std::size_t scenario = 8;
  std::size_t contender = 5;
  for (const Tally& each : tallies) {
    scenario = std::max(scenario, each.scenario.size());
    contender = std::max(contender, each.contender.size());
  }
  std::string text =
      fmt::format("{:<{}}  {:<{}}  {:>11}  {:>11}  {:>8}  {}\n", "scenario", scenario, "agent",
                  contender, "reached", "mean time s", "PAR-2 s", "others");
  for (const Tally& each : tallies) {
    const std::size_t count = CountOf(each, Outcome::kReached);
    text += fmt::format(
        "{:<{}}  {:<{}}  {:>11}  {:>11}  {:>8}  {}\n", each.scenario, scenario, each.contender,
        contender, ReachedOf(each), count == 0 ? "-" : fmt::format("{:.1f}", each.mean_time_s),
        each.runs > 0 && each.limit_s > 0 ? fmt::format("{:.1f}", each.par2_s) : "-",
        Outcomes(each));
  }
  return text;
}

/// Empty when all are made.
std::string RunsToMake(const Experiment& experiment, const std::vector<Tally>& tallies) {
  std::size_t made = 0;
  for (const Tally& each : tallies) made += each.runs;
  const std::size_t all = tallies.size() * (experiment.last_seed - experiment.first_seed + 1);
  return made == all ? "" : fmt::format("\n{} of {} runs are made so far\n", made, all);
}

/// What a run says may come from anywhere; a terminal obeys control characters.
std::string Printable(std::string text) {
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
  std::ranges::replace_if(text, is_control, ' ');
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {  // U+0080 to U+009F
    if (text[i] == '\xc2' && text[i + 1] < '\xa0') text.replace(i, 2, " ");
  }
  return text;
}

std::string Quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace

std::string ToText(const Experiment& experiment, const Findings& findings) {
  std::string text = fmt::format("{}: {}\n\n", experiment.name, Overview(experiment, findings));
  for (const AgentVerdict& verdict : Verdicts(experiment, findings)) {
    text += InWords(verdict, experiment.contenders.front().name);
  }
  text += '\n' + Table(findings.tallies);
  text += RunsToMake(experiment, findings.tallies);
  if (findings.failures.empty()) return text;
  text +=
      fmt::format("\n{} runs did not reach their goal; to repeat one:\n", findings.failures.size());
  for (std::size_t i = 0; i < std::min(findings.failures.size(), kMostFailures); ++i) {
    const RunRecord& run = findings.failures[i];
    text += fmt::format("  {} ({}: {})\n", RepeatOf(run, experiment.limits), Name(run.outcome),
                        Printable(run.message));
  }
  if (findings.failures.size() > kMostFailures) {
    text += fmt::format("  and {} more in runs.csv\n", findings.failures.size() - kMostFailures);
  }
  return text;
}

std::string ToCsv(const Records& records, const RunLimits& limits) {
  std::string text =
      "scenario,agent,seed,outcome,message,time_s,distance_m,collisions,wall_s,cpu_s,command\n";
  for (const auto& [key, run] : records) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{}\n",
                   Quoted(key.scenario), Quoted(key.contender), key.seed, Name(run.outcome),
                   Quoted(run.message), run.time_s, run.distance_m, run.collisions, run.wall_s,
                   run.cpu_s, Quoted(RepeatOf(run, limits)));
  }
  return text;
}

}  // namespace latchwork::compare
