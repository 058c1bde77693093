// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_RUNS_RUN_QUEUE_H_
#define LATCHWORK_APPS_COMPARE_RUNS_RUN_QUEUE_H_

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "apps/compare/runs/fork_server.h"

namespace latchwork::compare {

/// One run, in a process of its own. Nothing when it was cut off because `stop` was set: then the
/// server is ended too.
std::optional<RunRecord> MakeRun(ForkServer& server, const Task& task,
                                 const std::atomic<bool>& stop);

struct QueueOptions {
  Launch launch;
  RunLimits limits;
  unsigned jobs = 1;
  /// Told of each run that ended, one at a time; false ends the work.
  std::function<bool(const RunRecord& record)> on_done;
};

/// Makes runs, `jobs` at a time, in order. Runs that were cut off are told to nobody.
void MakeRuns(const std::vector<PlannedRun>& runs, const QueueOptions& options,
              std::atomic<bool>& stop);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_RUNS_RUN_QUEUE_H_
