// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "apps/compare/report/findings.h"

namespace latchwork::compare {
namespace {

constexpr std::size_t kMostFailures = 20;

std::string Subject(Verdict verdict, const Duel& duel, std::string_view better) {
  if (verdict == Verdict::kNoDifferenceShown) return "no difference shown";
  return fmt::format("{} {}", verdict == Verdict::kFirstBetter ? duel.first : duel.second, better);
}

std::string InWords(const Duel& duel, double level) {
  const Comparison& c = duel.comparison;
  return fmt::format(
      "{}, {} against {}: goals reached: {} ({} and {} of {}; p = {:.3g}); time: {} "
      "(mean difference {:+.1f} s, 95 % {:+.1f} to {:+.1f}; p = {:.3g})\n",
      duel.scenario, duel.first, duel.second, Subject(OnSuccess(c, level), duel, "reaches more"),
      c.first_reached, c.second_reached, c.pairs, c.p_success_corrected,
      Subject(OnTime(c, level), duel, "is faster"), c.difference.mean, c.difference.low,
      c.difference.high, c.p_times_corrected);
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
  std::string text = fmt::format("{:<{}}  {:<{}}  {:>9}  {:>11}  {:>8}  {}\n", "scenario", scenario,
                                 "agent", contender, "reached", "mean time s", "PAR-2 s", "others");
  for (const Tally& each : tallies) {
    const auto reached = each.outcomes.find(Outcome::kReached);
    const std::size_t count = reached == each.outcomes.end() ? 0 : reached->second;
    text += fmt::format("{:<{}}  {:<{}}  {:>9}  {:>11}  {:>8.1f}  {}\n", each.scenario, scenario,
                        each.contender, contender, fmt::format("{} of {}", count, each.runs),
                        count == 0 ? "-" : fmt::format("{:.1f}", each.mean_time_s), each.par2_s,
                        Outcomes(each));
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
  std::string text =
      fmt::format("{}: {} against the others; level {}, all tests together\n\n", experiment.name,
                  experiment.contenders.front().name, experiment.level);
  for (const Duel& duel : findings.duels) text += InWords(duel, experiment.level);
  text += '\n' + Table(findings.tallies);
  if (findings.failures.empty()) return text;
  text +=
      fmt::format("\n{} runs did not reach their goal; to repeat one:\n", findings.failures.size());
  for (std::size_t i = 0; i < std::min(findings.failures.size(), kMostFailures); ++i) {
    const RunRecord& run = findings.failures[i];
    text += fmt::format("  {} ({}: {})\n", run.command, Name(run.outcome), run.message);
  }
  if (findings.failures.size() > kMostFailures) {
    text += fmt::format("  and {} more in runs.csv\n", findings.failures.size() - kMostFailures);
  }
  return text;
}

std::string ToCsv(const std::map<RunKey, RunRecord>& records) {
  std::string text =
      "scenario,agent,seed,outcome,message,time_s,distance_m,collisions,wall_s,cpu_s,command\n";
  for (const auto& [key, run] : records) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{}\n",
                   Quoted(key.scenario), Quoted(key.contender), key.seed, Name(run.outcome),
                   Quoted(run.message), run.time_s, run.distance_m, run.collisions, run.wall_s,
                   run.cpu_s, Quoted(run.command));
  }
  return text;
}

}  // namespace latchwork::compare
