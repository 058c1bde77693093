// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace latchwork::compare {
namespace {

/// All figures are the agent's minus the first's: more goals, more seconds.
std::string OfSuccess(const Comparison& c) {
  std::string counts =
      fmt::format("{} of {} against {}", c.second_reached, c.pairs, c.first_reached);
  if (c.discordant.only_first + c.discordant.only_second == 0) return counts;
  return fmt::format("{}: {} points of 100, 95 % {} to {}; {}", counts,
                     Signed(-100 * c.success.mean, 0), Signed(-100 * c.success.high, 0),
                     Signed(-100 * c.success.low, 0), PValue(c.p_success_corrected));
}

std::string OfTime(const Comparison& c) {
  if (c.times.counted == 0) return "the same with every seed";
  return fmt::format("{} s in the mean, 95 % {} to {} s; effect {}; {}",
                     Signed(-c.difference.mean, 1), Signed(-c.difference.high, 1),
                     Signed(-c.difference.low, 1), Signed(-c.times.effect, 2),
                     PValue(c.p_times_corrected));
}

void Append(std::string& list, std::string_view separator, std::string_view item) {
  if (!list.empty()) list += separator;
  list += item;
}

AgentVerdict VerdictOn(const std::string& contender, const std::vector<Duel>& duels, double level) {
  AgentVerdict verdict{contender, {}, {}, false};
  std::string goals;
  std::string times;
  for (const Duel& duel : duels) {
    const Comparison& c = duel.comparison;
    if (duel.second != contender || c.pairs == 0) continue;
    verdict.compared = true;
    const Verdict success = OnSuccess(c, level);
    if (success == Verdict::kNoDifferenceShown) {
      Append(goals, ", ", fmt::format("{} ({})", duel.scenario, OfSuccess(c)));
    } else {
      const bool fewer = success == Verdict::kFirstBetter;
      verdict.differences.push_back(
          {duel.scenario, fewer ? "reaches fewer goals" : "reaches more goals", OfSuccess(c)});
    }
    if (duel.limit_s == 0) continue;
    const Verdict time = OnTime(c, level);
    if (time == Verdict::kNoDifferenceShown) {
      Append(times, ", ", fmt::format("{} ({})", duel.scenario, OfTime(c)));
    } else {
      const bool slower = time == Verdict::kFirstBetter;
      verdict.differences.push_back({duel.scenario, slower ? "is slower" : "is faster", OfTime(c)});
    }
  }
  if (!goals.empty()) verdict.not_shown.push_back("goals reached: " + goals);
  if (!times.empty()) verdict.not_shown.push_back("time: " + times);
  return verdict;
}

/// "slow is slower in floor and far"; empty when there is no difference.
std::string InShort(const AgentVerdict& verdict) {
  std::string text;
  for (const char* what : {"reaches fewer goals", "reaches more goals", "is slower", "is faster"}) {
    std::string scenarios;
    for (const Difference& each : verdict.differences) {
      if (each.what == what) Append(scenarios, ", ", each.scenario);
    }
    if (!scenarios.empty()) Append(text, " and ", fmt::format("{} in {}", what, scenarios));
  }
  return text.empty() ? "" : verdict.contender + ' ' + text;
}

/// Fewest and most extreme as they may be, would these pairs pass Holm's first step?
std::string TooFewSeeds(const Experiment& experiment, const Findings& findings) {
  std::size_t pairs = 0;
  for (const Duel& duel : findings.duels) pairs = std::max(pairs, duel.comparison.pairs);
  const double smallest = std::ldexp(2.0, -static_cast<int>(std::min<std::size_t>(pairs, 1000))) *
                          2 * static_cast<double>(findings.duels.size());
  if (pairs == 0 || smallest <= experiment.level) return "";
  return fmt::format(
      " {} seeds are too few to show any: where all of them agree, p is {:.3g} after the "
      "correction. --plan says how many are needed.",
      pairs, std::min(1.0, smallest));
}

}  // namespace

std::vector<AgentVerdict> Verdicts(const Experiment& experiment, const Findings& findings) {
  std::vector<AgentVerdict> verdicts;
  for (std::size_t i = 1; i < experiment.contenders.size(); ++i) {
    verdicts.push_back(VerdictOn(experiment.contenders[i].name, findings.duels, experiment.level));
  }
  return verdicts;
}

std::string Overview(const Experiment& experiment, const Findings& findings) {
  std::string found;
  std::string others;
  std::string unknown;
  for (const AgentVerdict& verdict : Verdicts(experiment, findings)) {
    if (const std::string text = InShort(verdict); !text.empty()) {
      Append(found, "; ", text);
    } else {
      Append(verdict.compared ? others : unknown, ", ", verdict.contender);
    }
  }
  std::string overview;
  if (!found.empty()) {
    overview = fmt::format("Against {}, {}. ", experiment.contenders.front().name, found);
  }
  if (!others.empty()) {
    overview += fmt::format("No difference from {} is shown for {}. ",
                            experiment.contenders.front().name, others);
  }
  if (!unknown.empty()) {
    overview += fmt::format("Nothing is known yet of {}: {} and it have no run with the same seed.",
                            unknown, experiment.contenders.front().name);
  }
  if (overview.ends_with(' ')) overview.pop_back();
  if (found.empty()) overview += TooFewSeeds(experiment, findings);
  return overview;
}

std::string ReachedOf(const Tally& tally) {
  return tally.runs == 0 ? "no runs yet"
                         : fmt::format("{} of {}", CountOf(tally, Outcome::kReached), tally.runs);
}

std::string PFigure(double p) { return p < 0.001 ? "< 0.001" : fmt::format("{:.3g}", p); }

std::string PValue(double p) { return p < 0.001 ? "p < 0.001" : fmt::format("p = {:.3g}", p); }

std::string Signed(double value, int digits) {
  const std::string text = fmt::format("{:+.{}f}", value, digits);
  return text.find_first_of("123456789") == std::string::npos ? text.substr(1) : text;
}

}  // namespace latchwork::compare
