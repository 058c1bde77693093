// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "apps/compare/report/html.h"

namespace latchwork::compare {
namespace {

std::string Describe(const Contender& contender) {
  std::string text = contender.fragment
                         ? fmt::format("<code>{}</code>", Escaped(contender.fragment->string()))
                         : "the scenario’s agent as it is";
  for (const std::string& setting : contender.settings) {
    text += fmt::format(", <code>--set {}</code>", Escaped(setting));
  }
  if (contender.seed_offset > 0) text += fmt::format(", seeds + {}", contender.seed_offset);
  return text;
}

double Processor(const Records& records) {
  double seconds = 0;
  for (const auto& [key, run] : records) seconds += run.cpu_s;
  return seconds;
}

}  // namespace

std::string MakingSection(const ReportInput& input) {
  const Experiment& experiment = input.experiment;
  std::string section = fmt::format(
      "<section id=\"making\">\n<h2>How this was made</h2>\n<dl>\n<dt>Command</dt><dd><code>{}"
      "</code></dd>\n<dt>Program</dt><dd>{} {}</dd>\n<dt>Seeds</dt><dd>{} to {}, the same for all "
      "agents</dd>\n<dt>A run is ended</dt><dd>after {:g} s on the clock, or beyond {} MB</dd>\n"
      "<dt>Scenarios</dt>",
      Escaped(input.making.command), Escaped(input.making.program), Escaped(input.making.version),
      experiment.first_seed, experiment.last_seed, experiment.limits.wall_seconds,
      experiment.limits.memory_mb);
  for (const Scenario& scenario : experiment.scenarios) {
    section += fmt::format("<dd>{}: <code>{}</code></dd>\n", Escaped(scenario.name),
                           Escaped(scenario.file.string()));
  }
  section += "<dt>Agents</dt>";
  for (const Contender& contender : experiment.contenders) {
    section += fmt::format("<dd>{}{}: {}</dd>\n", Key(experiment, contender.name),
                           Escaped(contender.name), Describe(contender));
  }
  section += fmt::format(
      "<dt>Depends on the machine</dt><dd>only the times of decisions above, runs that timed out "
      "or "
      "ran out of memory, and the processor time of all runs: {:.0f} s</dd>\n</dl>\n",
      Processor(input.records));
  return section +
         "<p class=\"note\">All runs: <code>runs.csv</code>; what does not depend on the machine: "
         "<code>results.sqlite</code>; times: <code>timings.sqlite</code>, in the folder that this "
         "report was written to.</p>\n</section>\n";
}

}  // namespace latchwork::compare
