// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "apps/compare/report/html.h"
#include "apps/compare/report/verdicts.h"

namespace latchwork::compare {
namespace {

std::string Card(const ReportInput& input, const AgentVerdict& verdict) {
  std::string card =
      fmt::format("<div>\n<h3>{}{} <span class=\"note\">against {}</span></h3>\n",
                  Key(input.experiment, verdict.contender), Escaped(verdict.contender),
                  Escaped(input.experiment.contenders.front().name));
  card += "<ul>\n";
  if (!verdict.compared) {
    card += fmt::format("<li class=\"none\">{}</li>\n", kNotCompared);
  }
  for (const Difference& each : verdict.differences) {
    card += fmt::format("<li><strong>{} in {}</strong> ({})</li>\n", each.what,
                        Escaped(each.scenario), Figures(each.figures));
  }
  for (const std::string& each : verdict.not_shown) {
    card += fmt::format("<li class=\"none\">No difference shown: {}</li>\n", Figures(each));
  }
  card += "</ul>\n";
  return card + "</div>\n";
}

}  // namespace

std::string VerdictSection(const ReportInput& input) {
  const Experiment& experiment = input.experiment;
  const std::size_t seeds = experiment.last_seed - experiment.first_seed + 1;
  const std::size_t planned = seeds * experiment.scenarios.size() * experiment.contenders.size();
  std::string section = fmt::format(
      "<section id=\"verdict\">\n<h1>{}: agents compared</h1>\n<p class=\"lead\">{}</p>\n"
      "<p>{} agents in {} scenarios with {} seeds each: {} of {} runs are made, {} of them reached "
      "their goal. With the same seed all agents meet the same world. The chance of any false "
      "difference among all that is shown is at most {}; “no difference shown” does not say that "
      "there is none.</p>\n<div class=\"verdicts\">\n",
      Escaped(experiment.name), Escaped(Overview(experiment, input.findings)),
      experiment.contenders.size(), experiment.scenarios.size(), seeds, input.records.size(),
      planned, input.records.size() - input.findings.failures.size(), experiment.level);
  for (const AgentVerdict& verdict : Verdicts(experiment, input.findings)) {
    section += Card(input, verdict);
  }
  return section + "</div>\n</section>\n";
}

}  // namespace latchwork::compare
