// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_RUNS_RUN_PLAN_H_
#define LATCHWORK_APPS_COMPARE_RUNS_RUN_PLAN_H_

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "apps/compare/experiment/experiment.h"

namespace latchwork::compare {

/// Names a run within its experiment.
struct RunKey {
  std::string scenario;
  std::string contender;
  std::uint64_t seed = 0;
  friend auto operator<=>(const RunKey&, const RunKey&) = default;
};

/// One of `count` equal parts of an experiment; `index` from 0.
struct Shard {
  std::size_t index = 0;
  std::size_t count = 1;
};

/// A run, and the command that makes it, without the program.
struct PlannedRun {
  RunKey key;
  std::vector<std::string> arguments;
};

/// A word that a shell takes as it is.
std::string ForShell(const std::string& word);

/// What a person types to repeat a run, quoted for a shell.
std::string CommandOf(const PlannedRun& run);

/// All runs of an experiment's shard. Contenders take turns within a seed and stay together in one
/// shard: what is different on a machine, or changes there, meets all of them alike.
std::vector<PlannedRun> PlanRuns(const Experiment& experiment, const Shard& shard = {});

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_RUNS_RUN_PLAN_H_
