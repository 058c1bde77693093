// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_REPORT_RESULT_FILES_H_
#define LATCHWORK_APPS_COMPARE_REPORT_RESULT_FILES_H_

#include <atomic>
#include <filesystem>
#include <map>
#include <string>

#include "apps/compare/report/floor_plan.h"
#include "apps/compare/report/html.h"
#include "apps/compare/runs/run_record.h"

namespace latchwork::compare {

struct WrittenResults {
  std::string report;    ///< The text of report.txt.
  std::string problems;  ///< Empty, or a line for each file that cannot be written.
};

/// Where the runs come from.
struct Origin {
  Launch launch;  ///< Draws the floors for the report; without a program there are none.
  Making making;
  const std::atomic<bool>* stop = nullptr;  ///< Ends the drawing; may be null.
};

/// Writes all files of an experiment but its log, whatever is there.
WrittenResults WriteResultFiles(const std::filesystem::path& folder, const Experiment& experiment,
                                const std::map<RunKey, RunRecord>& records, const Origin& origin);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_REPORT_RESULT_FILES_H_
