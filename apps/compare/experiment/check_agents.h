// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_EXPERIMENT_CHECK_AGENTS_H_
#define LATCHWORK_APPS_COMPARE_EXPERIMENT_CHECK_AGENTS_H_

#include <atomic>
#include <vector>

#include "apps/compare/experiment/experiment.h"
#include "apps/compare/runs/launch.h"
#include "apps/compare/runs/run_plan.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::compare {

/// Lets `latchwork check` read each agent in each scenario of `runs`, once, within the limits of a
/// run. All that is wrong, each once: files, settings, and limits that no run can keep to.
logic::Diagnostics CheckAgents(const Experiment& experiment, const std::vector<PlannedRun>& runs,
                               const Launch& launch, const std::atomic<bool>& stop);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_EXPERIMENT_CHECK_AGENTS_H_
