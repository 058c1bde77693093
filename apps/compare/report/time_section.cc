// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "apps/compare/report/html.h"
#include "apps/compare/report/tables.h"
#include "apps/compare/report/time_charts.h"
#include "apps/compare/report/verdicts.h"

namespace latchwork::compare {
namespace {

std::string Seconds(double seconds) { return fmt::format("{:.1f}", seconds); }

/// A measure that counts the limit for what failed.
std::string Limited(const Tally& tally, double seconds) {
  if (tally.runs == 0) return "";
  return tally.limit_s > 0 ? Seconds(seconds) : "-";
}

std::vector<std::string> Cells(const ReportInput& input, const Tally& tally) {
  const std::size_t reached = CountOf(tally, Outcome::kReached);
  std::vector<std::string> cells = {
      ReachedOf(tally), reached == 0 ? "" : Seconds(tally.mean_time_s),
      Limited(tally, tally.restricted_s), Limited(tally, tally.par2_s)};
  const Duel* duel = FindDuel(input.findings, tally);
  if (duel == nullptr || duel->comparison.pairs == 0 || duel->limit_s == 0) {
    cells.insert(cells.end(), 4, "");
    return cells;
  }
  const Comparison& c = duel->comparison;
  cells.push_back(Spread(-c.difference.mean, -c.difference.high, -c.difference.low, 1));
  cells.push_back(Figures(Signed(-c.times.effect, 2)));
  cells.push_back(Figure(c.times.p, 1));
  cells.push_back(Figure(c.p_times_corrected, input.experiment.level));
  return cells;
}

std::string Keys(const ReportInput& input) {
  std::string keys = "<ul class=\"keys\">\n";
  for (const Contender& contender : input.experiment.contenders) {
    keys += fmt::format("<li>{}{}</li>\n", Key(input.experiment, contender.name),
                        Escaped(contender.name));
  }
  return keys + "</ul>\n";
}

std::string Charts(const ReportInput& input,
                   std::string (*draw)(const ReportInput&, const std::string&)) {
  std::string charts = "<div class=\"charts\">\n";
  for (const Scenario& scenario : input.experiment.scenarios) {
    charts += fmt::format("<figure>\n<figcaption>{}</figcaption>\n{}</figure>\n",
                          Escaped(scenario.name), draw(input, scenario.name));
  }
  return charts + "</div>\n";
}

}  // namespace

std::string TimeSection(const ReportInput& input) {
  std::string section = fmt::format(
      "<section id=\"times\">\n<h2>Time to the goal</h2>\n<p>Seconds in the world. No run is left "
      "out: in the restricted mean one that fails counts the whole duration, in PAR-2 twice that. "
      "The difference to {} is the mean of the paired differences of restricted times with its "
      "bootstrap interval; the effect is the matched-pairs rank-biserial correlation (+1: slower "
      "with every seed, −1: faster with every seed); p is Wilcoxon’s signed-rank test.</p>\n",
      Escaped(input.experiment.contenders.front().name));
  section += AgentTable(input, "Times in seconds",
                        {"reached", "mean of these", "restricted mean", "PAR‑2", "slower by (95 %)",
                         "effect", "p", "p, Holm"},
                        [&](const Tally& tally) { return Cells(input, tally); });
  section +=
      "<h3>Spread</h3>\n<p class=\"note\">Each dot is a run, each box the middle half of all runs "
      "with the median. Runs that did not reach the goal count as slower than all others and stand "
      "at the right with their number.</p>\n";
  section += Charts(input, BoxPlot);
  section +=
      "<h3>Share of runs that have reached the goal, by time</h3>\n<p class=\"note\">Runs that "
      "fail "
      "are never dropped: with them a curve ends below 100 %. The mark stands at the last run that "
      "reached the goal.</p>\n";
  section += Keys(input) + Charts(input, CurvePlot);
  return section + "</section>\n";
}

}  // namespace latchwork::compare
