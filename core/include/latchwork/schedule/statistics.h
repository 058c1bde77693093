// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_STATISTICS_H_
#define LATCHWORK_SCHEDULE_STATISTICS_H_

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/world.h"

namespace latchwork::schedule {

/// Figures of a sample. sd divides by n - 1 and is 0 below two values; a percentile is the smallest
/// value that at least so many per cent of the sample do not exceed ("nearest rank"). All 0 for an
/// empty sample.
struct Spread {
  double mean = 0;
  double sd = 0;
  double p50 = 0;
  double p99 = 0;
  double max = 0;
};

Spread Describe(std::vector<double> sample);

/// What a layer did in a run.
struct LayerStatistics {
  std::string name;
  std::string plugin;
  std::string reasoner;
  std::uint64_t decisions = 0;
  Spread time_us;                 ///< Wall time of Decide alone.
  Spread inferences;              ///< Of a decision.
  std::uint64_t budget_hits = 0;  ///< Decisions that a limit cut short.
  std::uint64_t retracted = 0;    ///< Defaults assumed in one decision and retracted in the next.
  std::uint64_t assumed_by_bound = 0;  ///< Assumptions that only a bound closed.
  std::uint64_t faults = 0;
  std::uint64_t refused = 0;  ///< Facts that did not get into its latches.
};

struct RunResult {
  enum class State : std::uint8_t {
    kReached,     ///< The world says that the goal is reached.
    kNotReached,  ///< The ticks were used up.
    kFailed,      ///< The world says so (a collision), or it threw.
    kStopped,     ///< An observer ended the run.
  };
  State state = State::kNotReached;
  std::string message;
  std::uint64_t ticks = 0;  ///< That were run whole.
  std::uint64_t seed = 0;
  double wall_seconds = 0;
  std::vector<std::pair<std::string, double>> measures;  ///< Of the world.
  std::vector<LayerStatistics> layers;
};

/// "reached", "not reached", "failed", "stopped".
std::string_view Name(RunResult::State state);

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_STATISTICS_H_
