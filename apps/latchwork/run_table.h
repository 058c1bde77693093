// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_RUN_TABLE_H_
#define LATCHWORK_APPS_LATCHWORK_RUN_TABLE_H_

#include <span>
#include <string>
#include <vector>

#include "apps/latchwork/run_agent.h"
#include "latchwork/schedule/statistics.h"

namespace latchwork::app {

/// Mean and standard deviation of the union of samples that are only known by size, mean and
/// deviation.
struct PooledSpread {
  double count = 0;
  double mean = 0;
  double sd = 0;
};
PooledSpread Pool(std::span<const PooledSpread> samples);

/// The outcome and a row per layer: decisions, time, inferences, budget hits, retracted defaults,
/// faults.
std::string OutcomeText(const FinishedRun& run);
std::string LayerTable(const schedule::RunResult& result);

/// The table of the LSA paper (IJCAI-99, figure 3): for each agent file how many runs reached their
/// goal and collided, and time and inferences of each layer as mean and standard deviation over all
/// decisions of all its runs.
std::string ScenarioTable(const std::vector<FinishedRun>& runs);

/// A line for each run that did not end well, with the command that repeats it; empty when there is
/// none.
std::string FailureList(const std::vector<FinishedRun>& runs);

double Measure(const schedule::RunResult& result, std::string_view name);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_RUN_TABLE_H_
