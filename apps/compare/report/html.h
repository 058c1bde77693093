// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_REPORT_HTML_H_
#define LATCHWORK_APPS_COMPARE_REPORT_HTML_H_

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "apps/compare/report/findings.h"
#include "apps/compare/report/floor_plan.h"
#include "latchwork/sdk/markup.h"

namespace latchwork::compare {

/// How an experiment was made, for whoever wants to make it again.
struct Making {
  std::string command;  ///< Of the whole experiment.
  std::string program = "latchwork";
  std::string version;
};

/// All that a report is made of. What it points to outlives it.
struct ReportInput {
  const Experiment& experiment;
  const Records& records;
  const Findings& findings;
  const std::map<std::string, Building>& buildings;
  Making making;
};

/// The report as one HTML file without references to others; the same input gives the same bytes.
std::string ToHtml(const ReportInput& input);

/// Its parts, each a <section>; empty when there is nothing to tell.
std::string VerdictSection(const ReportInput& input);
std::string SuccessSection(const ReportInput& input);
std::string TimeSection(const ReportInput& input);
std::string TrajectorySection(const ReportInput& input);
std::string LayerSection(const ReportInput& input);
std::string FailureSection(const ReportInput& input);
std::string MakingSection(const ReportInput& input);

/// The style sheet of the page.
std::string_view PageStyle();

using sdk::Escaped;

/// Escaped text with figures: with minus signs.
std::string Figures(std::string_view text);

/// The class that gives an agent its colour and its mark, "a0", "a1", …
std::string AgentClass(const Experiment& experiment, std::string_view contender);
/// The mark of the agent of this class at a place of a drawing.
std::string Mark(std::string_view agent_class, double x, double y);
/// A small drawing with the mark, before an agent's name.
std::string Key(const Experiment& experiment, std::string_view contender);

/// The runs of an agent in a scenario, by seed.
std::vector<const RunRecord*> RunsOf(const ReportInput& input, const std::string& scenario,
                                     const std::string& contender);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_REPORT_HTML_H_
