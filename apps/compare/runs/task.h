// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_RUNS_TASK_H_
#define LATCHWORK_APPS_COMPARE_RUNS_TASK_H_

#include <optional>
#include <string>
#include <string_view>

#include "apps/compare/runs/run_plan.h"

namespace latchwork::compare {

/// A run for a process elsewhere: all that it needs to know of the experiment.
struct Task {
  PlannedRun run;
  RunLimits limits;
};

/// One line of JSON, and back; nothing for a text that is none.
std::string ToText(const Task& task);
std::optional<Task> TaskFromText(std::string_view text);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_RUNS_TASK_H_
