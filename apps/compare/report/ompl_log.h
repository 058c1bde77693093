// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_REPORT_OMPL_LOG_H_
#define LATCHWORK_APPS_COMPARE_REPORT_OMPL_LOG_H_

#include <string>

#include "apps/compare/report/html.h"

namespace latchwork::compare {

/// The runs of a scenario as a benchmark log of OMPL, which `ompl_benchmark_statistics` makes a
/// database of for Planner Arena; agents stand where it has planners. Such a log holds one
/// experiment. Source: OMPL 1.5, "How to benchmark planners", the grammar of log files.
std::string ToOmplLog(const ReportInput& input, const std::string& scenario);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_REPORT_OMPL_LOG_H_
