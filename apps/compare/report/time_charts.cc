// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/time_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "apps/compare/report/time_axis.h"
#include "apps/compare/report/verdicts.h"

namespace latchwork::compare {
namespace {

using Runs = std::vector<const RunRecord*>;

constexpr std::size_t kMostDots = 200;  // of an agent
constexpr double kRow = 46;
constexpr double kCurveTop = 12;
constexpr double kCurveBottom = 190;

Runs AllRuns(const ReportInput& input, const std::string& scenario) {
  Runs all;
  for (const Contender& contender : input.experiment.contenders) {
    const Runs runs = RunsOf(input, scenario, contender.name);
    all.insert(all.end(), runs.begin(), runs.end());
  }
  return all;
}

/// The fastest first, then those that failed.
Runs Sorted(Runs runs) {
  std::ranges::stable_sort(runs, [](const RunRecord* a, const RunRecord* b) {
    const bool a_reached = a->outcome == Outcome::kReached;
    const bool b_reached = b->outcome == Outcome::kReached;
    if (a_reached != b_reached) return a_reached;
    return a_reached && a->time_s < b->time_s;
  });
  return runs;
}

std::size_t Reached(const Runs& runs) {
  return static_cast<std::size_t>(std::ranges::count(runs, Outcome::kReached, &RunRecord::outcome));
}

/// The smallest run that at least `quarters` quarters of the sample do not exceed.
const RunRecord& Quartile(const Runs& sorted, std::size_t quarters) {
  return *sorted[(quarters * sorted.size() + 3) / 4 - 1];
}

std::string Box(const TimeAxis& axis, const Runs& sorted, double y) {
  const std::size_t reached = Reached(sorted);
  if (reached == 0) return "";
  const double first = axis.X(Quartile(sorted, 1));
  const double third = axis.X(Quartile(sorted, 3));
  const double slowest = axis.X(*sorted[reached - 1]);
  std::string box = fmt::format("<path class=\"box\" d=\"M{:.1f},{:.1f}H{:.1f}",
                                axis.X(*sorted.front()), y, first);
  if (slowest > third) box += fmt::format("M{:.1f},{:.1f}H{:.1f}", third, y, slowest);
  box += fmt::format("M{0:.1f},{1:.1f}H{2:.1f}V{3:.1f}H{0:.1f}Z\"/>", first, y - 7, third, y + 7);
  box += fmt::format("<path class=\"median\" d=\"M{:.1f},{:.1f}V{:.1f}\"/>",
                     axis.X(Quartile(sorted, 2)), y - 7, y + 7);
  return box;
}

/// Side by side in turn, so that equal times are seen.
std::string Dots(const TimeAxis& axis, const Runs& sorted, std::string_view agent_class, double y) {
  std::string dots;
  const std::size_t reached = Reached(sorted);
  if (sorted.size() <= kMostDots) {
    dots += fmt::format("<g class=\"run mark {}\">", agent_class);
    for (std::size_t i = 0; i < reached; ++i) {
      const double offset = static_cast<double>(i % 5) * 2.5 - 5;
      dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\"/>", axis.X(*sorted[i]),
                          y + offset);
    }
    dots += "</g>";
  }
  if (reached < sorted.size()) {
    const double x = axis.X(*sorted.back());
    dots += fmt::format(
        "<path class=\"fail\" d=\"M{0:.1f},{1:.1f}l7,7m0,-7l-7,7\"/>"
        "<text x=\"{2:.1f}\" y=\"{3:.1f}\">{4}</text>",
        x - 8, y - 3.5, x + 4, y + 4, sorted.size() - reached);
  }
  return dots;
}

std::string ChartHead(const ReportInput& input, const std::string& scenario, double height,
                      std::string_view kind, std::string_view title) {
  const auto found = std::ranges::find(input.experiment.scenarios, scenario, &Scenario::name);
  const std::string id = fmt::format("{}-{}", kind, found - input.experiment.scenarios.begin());
  std::string text;
  for (const Tally& tally : input.findings.tallies) {
    if (tally.scenario != scenario) continue;
    const std::size_t reached = CountOf(tally, Outcome::kReached);
    text += fmt::format("{}{}: {}{}", text.empty() ? "" : "; ", tally.contender, ReachedOf(tally),
                        tally.runs == 0 ? "" : " reached");
    if (reached > 0) text += fmt::format(", those in {:.1f} s in the mean", tally.mean_time_s);
  }
  return fmt::format(
      "<svg class=\"chart {0}\" viewBox=\"0 0 {1:.0f} {2:.0f}\" role=\"img\" "
      "aria-labelledby=\"{3}-t {3}-d\"><title id=\"{3}-t\">{4}, {5}</title>"
      "<desc id=\"{3}-d\">{6}.</desc>\n",
      kind, kChartWidth, height, id, title, Escaped(scenario), Escaped(text));
}

std::string Curve(const TimeAxis& axis, const Runs& sorted, std::string_view agent_class) {
  const std::size_t reached = Reached(sorted);
  const auto y = [&](std::size_t count) {
    return kCurveBottom - (kCurveBottom - kCurveTop) * static_cast<double>(count) /
                              static_cast<double>(sorted.size());
  };
  std::string path = fmt::format("M{:.1f},{:.1f}", axis.left(), y(0));
  for (std::size_t i = 0; i < reached; ++i) {
    path += fmt::format("H{:.1f}V{:.1f}", axis.X(*sorted[i]), y(i + 1));
  }
  path += fmt::format("H{:.1f}", axis.right() + 4);
  return fmt::format(
      "<path class=\"curve {}\" d=\"{}\"/>{}\n", agent_class, path,
      Mark(agent_class, reached == 0 ? axis.right() : axis.X(*sorted[reached - 1]), y(reached)));
}

}  // namespace

std::string BoxPlot(const ReportInput& input, const std::string& scenario) {
  const TimeAxis axis(AllRuns(input, scenario), true);
  const double bottom = kRow * static_cast<double>(input.experiment.contenders.size()) + 4;
  std::string chart =
      ChartHead(input, scenario, bottom + 32, "boxes", "Times to the goal") + axis.Draw(4, bottom);
  double y = 4;
  for (const Contender& contender : input.experiment.contenders) {
    const Runs sorted = Sorted(RunsOf(input, scenario, contender.name));
    chart += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", axis.left(), y + 13,
                         Escaped(contender.name));
    if (!sorted.empty()) {
      chart += Dots(axis, sorted, AgentClass(input.experiment, contender.name), y + 29);
      chart += Box(axis, sorted, y + 29);
    }
    chart += '\n';
    y += kRow;
  }
  return chart + "</svg>\n";
}

std::string CurvePlot(const ReportInput& input, const std::string& scenario) {
  const TimeAxis axis(AllRuns(input, scenario), false);
  std::string chart = ChartHead(input, scenario, kCurveBottom + 20, "curves",
                                "Share of runs that reached the goal, by time") +
                      axis.Draw(kCurveTop, kCurveBottom);
  for (int quarter = 1; quarter <= 4; ++quarter) {
    const double y = kCurveBottom - (kCurveBottom - kCurveTop) * quarter / 4;
    fmt::format_to(std::back_inserter(chart),
                   "<path class=\"grid\" d=\"M{0:.1f},{1:.1f}H{2:.1f}\"/><text class=\"soft\" "
                   "x=\"{0:.1f}\" y=\"{3:.1f}\">{4}{5}</text>",
                   axis.left(), y, axis.right() + 4, y - 2, 25 * quarter, quarter == 4 ? " %" : "");
  }
  chart += '\n';
  for (const Contender& contender : input.experiment.contenders) {
    const Runs sorted = Sorted(RunsOf(input, scenario, contender.name));
    if (sorted.empty()) continue;
    chart += Curve(axis, sorted, AgentClass(input.experiment, contender.name));
  }
  return chart + "</svg>\n";
}

}  // namespace latchwork::compare
