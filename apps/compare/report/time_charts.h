// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_REPORT_TIME_CHARTS_H_
#define LATCHWORK_APPS_COMPARE_REPORT_TIME_CHARTS_H_

#include <string>

#include "apps/compare/report/html.h"

namespace latchwork::compare {

/// The times of all agents in a scenario as boxes (quartiles of all runs, what failed being the
/// slowest; whiskers to the fastest and slowest that reached the goal) and single runs.
std::string BoxPlot(const ReportInput& input, const std::string& scenario);

/// The share of all runs that have reached the goal by a time: with failures it never gets to 1.
std::string CurvePlot(const ReportInput& input, const std::string& scenario);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_REPORT_TIME_CHARTS_H_
