// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_RUNS_RUN_QUEUE_H_
#define LATCHWORK_APPS_COMPARE_RUNS_RUN_QUEUE_H_

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "apps/compare/runs/run_record.h"

namespace latchwork::compare {

struct QueueOptions {
  std::filesystem::path program;       ///< What makes a run: latchwork itself.
  std::vector<std::string> arguments;  ///< Before those of the run.
  RunLimits limits;
  unsigned jobs = 1;
  /// Told of each run that ended, one at a time; false ends the work.
  std::function<bool(const RunRecord& record)> on_done;
};

/// Makes runs, each in a process of its own, `jobs` at a time, in order. Runs that were cut off
/// because `stop` was set are told to nobody.
void MakeRuns(const std::vector<PlannedRun>& runs, const QueueOptions& options,
              std::atomic<bool>& stop);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_RUNS_RUN_QUEUE_H_
