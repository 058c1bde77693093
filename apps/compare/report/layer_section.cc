// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "apps/compare/report/html.h"
#include "apps/compare/report/tables.h"

namespace latchwork::compare {
namespace {

/// A layer over all runs of an agent in a scenario.
struct LayerCost {
  std::string name;
  std::set<std::string> reasoners;
  std::size_t runs = 0;
  std::uint64_t decisions = 0;
  double inferences = 0;  ///< In all.
  std::uint64_t budget_hits = 0;
  std::uint64_t assumed_by_bound = 0;
  std::uint64_t faults = 0;
  std::vector<double> medians_us;
  std::vector<double> p99s_us;
};

double Median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

void Add(const LayerRecord& layer, std::vector<LayerCost>& costs) {
  auto cost = std::ranges::find(costs, layer.name, &LayerCost::name);
  if (cost == costs.end()) {
    costs.emplace_back().name = layer.name;
    cost = costs.end() - 1;
  }
  cost->reasoners.insert(layer.reasoner);
  ++cost->runs;
  cost->decisions += layer.decisions;
  cost->inferences += layer.inferences * static_cast<double>(layer.decisions);
  cost->budget_hits += layer.budget_hits;
  cost->assumed_by_bound += layer.assumed_by_bound;
  cost->faults += layer.faults;
  if (layer.decisions == 0) return;
  cost->medians_us.push_back(layer.p50_us);
  cost->p99s_us.push_back(layer.p99_us);
}

std::string Row(const ReportInput& input, const std::string& contender, const LayerCost& cost) {
  std::string reasoners;
  for (const std::string& each : cost.reasoners) {
    reasoners += (reasoners.empty() ? "" : ", ") + Escaped(each);
  }
  const double each =
      cost.decisions == 0 ? 0 : cost.inferences / static_cast<double>(cost.decisions);
  return fmt::format(
      "<tr><td class=\"l\">{}{}</td><th scope=\"row\" class=\"l\">{}</th><td class=\"l\">{}</td>"
      "<td>{}</td><td>{:.1f}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.1f}</td><td>{:.1f}</td>"
      "</tr>\n",
      Key(input.experiment, contender), Escaped(contender), Escaped(cost.name), reasoners,
      cost.decisions, each, Count(cost.budget_hits), Count(cost.assumed_by_bound),
      Count(cost.faults), Median(cost.medians_us), Median(cost.p99s_us));
}

std::string Rows(const ReportInput& input, const std::string& scenario) {
  std::string rows;
  for (const Contender& contender : input.experiment.contenders) {
    std::vector<LayerCost> costs;
    for (const RunRecord* run : RunsOf(input, scenario, contender.name)) {
      for (const LayerRecord& layer : run->layers) Add(layer, costs);
    }
    for (const LayerCost& cost : costs) rows += Row(input, contender.name, cost);
  }
  return rows;
}

}  // namespace

std::string LayerSection(const ReportInput& input) {
  std::string tables;
  for (const Scenario& scenario : input.experiment.scenarios) {
    const std::string rows = Rows(input, scenario.name);
    if (rows.empty()) continue;
    tables += TableHead(scenario.name + ": what the layers cost",
                        {"agent", "layer", "reasoner", "decisions", "inferences each",
                         "budget used up", "assumed by bound", "faults", "median µs", "p99 µs"},
                        3);
    tables += rows;
    tables.append(kTableEnd);
  }
  if (tables.empty()) return "";
  return "<section id=\"layers\">\n<h2>What the layers cost</h2>\n<p>Decisions and inferences are "
         "the same on every machine. The times of a decision are not: they are those of the "
         "machine, or machines, that made these runs (the median over the runs of each run’s "
         "median and 99th percentile). Runs that crashed or timed out left no figures.</p>\n" +
         tables + "</section>\n";
}

}  // namespace latchwork::compare
