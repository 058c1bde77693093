// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "apps/compare/report/html.h"
#include "apps/compare/report/tables.h"
#include "apps/compare/report/verdicts.h"
#include "apps/compare/statistics/shares.h"

namespace latchwork::compare {
namespace {

/// The ways to fail that occur, in their order.
std::vector<Outcome> FailuresIn(const Findings& findings) {
  std::vector<Outcome> occurring;
  for (const Outcome outcome : {Outcome::kCollision, Outcome::kNotReached, Outcome::kFailed,
                                Outcome::kTimedOut, Outcome::kCrashed}) {
    const auto occurs = [&](const RunRecord& run) { return run.outcome == outcome; };
    if (std::ranges::any_of(findings.failures, occurs)) occurring.push_back(outcome);
  }
  return occurring;
}

std::string Percent(double share) { return fmt::format("{:.0f}", 100 * share); }

std::vector<std::string> Cells(const ReportInput& input, const std::vector<Outcome>& failures,
                               const Tally& tally) {
  const Interval share = Share(CountOf(tally, Outcome::kReached), tally.runs);
  std::vector<std::string> cells = {
      ReachedOf(tally),
      tally.runs == 0 ? "" : fmt::format("{} to {} %", Percent(share.low), Percent(share.high))};
  for (const Outcome outcome : failures) cells.push_back(Count(CountOf(tally, outcome)));
  const Duel* duel = FindDuel(input.findings, tally);
  if (duel == nullptr || duel->comparison.pairs == 0) {
    cells.insert(cells.end(), 4, "");
    return cells;
  }
  const Comparison& c = duel->comparison;
  cells.push_back(Spread(-100 * c.success.mean, -100 * c.success.high, -100 * c.success.low, 0));
  cells.push_back(fmt::format("{} / {}", c.discordant.only_second, c.discordant.only_first));
  cells.push_back(Figure(c.p_success, 1));
  cells.push_back(Figure(c.p_success_corrected, input.experiment.level));
  return cells;
}

}  // namespace

std::string SuccessSection(const ReportInput& input) {
  const std::string first = Escaped(input.experiment.contenders.front().name);
  const std::vector<Outcome> failures = FailuresIn(input.findings);
  std::vector<std::string> heads = {"reached", "share (95 %)"};
  for (const Outcome outcome : failures) heads.emplace_back(Name(outcome));
  for (const char* head : {"points more (95 %)", "won / lost", "p", "p, Holm"}) {
    heads.emplace_back(head);
  }
  std::string section = fmt::format(
      "<section id=\"success\">\n<h2>Goals reached</h2>\n<p>How every run ended; no run ended in a "
      "way that has no column. Then the difference to {}: in points of 100 runs with its interval "
      "(Agresti and Min), the seeds that only the one or only the other brought to the goal (won / "
      "lost), and McNemar’s exact test on these, as it is and corrected for all tests of this "
      "report (Holm). Bold: a difference is shown.</p>\n",
      first);
  section += AgentTable(input, "Runs by outcome", heads,
                        [&](const Tally& tally) { return Cells(input, failures, tally); });
  return section + "</section>\n";
}

}  // namespace latchwork::compare
