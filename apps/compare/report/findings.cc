// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/findings.h"

#include <algorithm>

namespace latchwork::compare {
namespace {

RunScore ScoreOf(const RunRecord& record) {
  return {record.outcome == Outcome::kReached, record.time_s};
}

Tally Count(const Experiment& experiment, const Records& records, const std::string& scenario,
            const std::string& contender, double limit) {
  Tally tally{scenario, contender, 0, {}, limit, 0, 0, 0};
  double reached_s = 0;
  for (std::uint64_t seed = experiment.first_seed; seed <= experiment.last_seed; ++seed) {
    const auto run = records.find({scenario, contender, seed});
    if (run == records.end()) continue;
    ++tally.runs;
    ++tally.outcomes[run->second.outcome];
    const bool reached = run->second.outcome == Outcome::kReached;
    if (reached) reached_s += run->second.time_s;
    tally.restricted_s += reached ? run->second.time_s : limit;
    tally.par2_s += reached ? run->second.time_s : 2 * limit;
  }
  const std::size_t reached = tally.outcomes[Outcome::kReached];
  if (reached > 0) tally.mean_time_s = reached_s / static_cast<double>(reached);
  if (tally.runs > 0) {
    tally.restricted_s /= static_cast<double>(tally.runs);
    tally.par2_s /= static_cast<double>(tally.runs);
  }
  return tally;
}

Duel Fight(const Experiment& experiment, const Records& records, const std::string& scenario,
           const std::string& second, double limit) {
  const std::string& first = experiment.contenders.front().name;
  std::vector<RunScore> ours;
  std::vector<RunScore> theirs;
  for (std::uint64_t seed = experiment.first_seed; seed <= experiment.last_seed; ++seed) {
    const auto one = records.find({scenario, first, seed});
    const auto other = records.find({scenario, second, seed});
    if (one == records.end() || other == records.end()) continue;
    ours.push_back(ScoreOf(one->second));
    theirs.push_back(ScoreOf(other->second));
  }
  return {scenario, first, second, limit, Compare(ours, theirs, limit, experiment.first_seed)};
}

void Correct(std::vector<Duel>& duels) {
  std::vector<Comparison> comparisons;
  for (const Duel& duel : duels) comparisons.push_back(duel.comparison);
  CorrectTogether(comparisons);
  for (std::size_t i = 0; i < duels.size(); ++i) duels[i].comparison = comparisons[i];
}

}  // namespace

double LimitOf(const Records& records, const std::string& scenario) {
  double limit = 0;
  for (const auto& [key, run] : records) {
    if (key.scenario == scenario) limit = std::max({limit, run.duration_s, run.time_s});
  }
  return limit;
}

std::size_t CountOf(const Tally& tally, Outcome outcome) {
  const auto found = tally.outcomes.find(outcome);
  return found == tally.outcomes.end() ? 0 : found->second;
}

Findings Evaluate(const Experiment& experiment, const Records& records) {
  Findings findings;
  for (const Scenario& scenario : experiment.scenarios) {
    const double limit = LimitOf(records, scenario.name);
    for (const Contender& contender : experiment.contenders) {
      findings.tallies.push_back(Count(experiment, records, scenario.name, contender.name, limit));
    }
    for (std::size_t i = 1; i < experiment.contenders.size(); ++i) {
      findings.duels.push_back(
          Fight(experiment, records, scenario.name, experiment.contenders[i].name, limit));
    }
  }
  Correct(findings.duels);
  for (const auto& [key, run] : records) {
    if (run.outcome != Outcome::kReached) findings.failures.push_back(run);
  }
  return findings;
}

}  // namespace latchwork::compare
