// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "apps/compare/report/html.h"

namespace latchwork::compare {
namespace {

std::string Item(const RunRecord& run, const RunLimits& limits) {
  return fmt::format("<li>seed {}: {}{}{}\n<code>{}</code></li>\n", run.key.seed, Name(run.outcome),
                     run.message.empty() ? "" : ", ", Escaped(run.message),
                     Escaped(RepeatOf(run, limits)));
}

}  // namespace

std::string FailureSection(const ReportInput& input) {
  if (input.findings.failures.empty()) return "";
  std::string section =
      "<section id=\"failures\">\n<h2>Runs that did not reach their goal</h2>\n"
      "<p>Each with the command that makes it again, to be given where the experiment was.</p>\n";
  for (const Tally& tally : input.findings.tallies) {
    std::string items;
    std::size_t count = 0;
    for (const RunRecord* run : RunsOf(input, tally.scenario, tally.contender)) {
      if (run->outcome == Outcome::kReached) continue;
      items += Item(*run, input.experiment.limits);
      ++count;
    }
    if (count == 0) continue;
    section += fmt::format(
        "<details>\n<summary>{}, {}{}: {} of {}</summary>\n<ul class=\"commands\">\n{}</ul>\n"
        "</details>\n",
        Escaped(tally.scenario), Key(input.experiment, tally.contender), Escaped(tally.contender),
        count, tally.runs, items);
  }
  return section + "</section>\n";
}

}  // namespace latchwork::compare
