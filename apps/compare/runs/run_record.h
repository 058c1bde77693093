// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_RUNS_RUN_RECORD_H_
#define LATCHWORK_APPS_COMPARE_RUNS_RUN_RECORD_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/compare/runs/run_plan.h"
#include "core/process/child_process.h"

namespace latchwork::compare {

/// How a run ended. Every one counts.
enum class Outcome : std::uint8_t {
  kReached,     ///< The goal, without a collision.
  kCollision,   ///< Whatever else it did.
  kNotReached,  ///< When its time in the world was over.
  kFailed,      ///< The world said so.
  kTimedOut,    ///< It took longer than the experiment allows.
  kCrashed,     ///< By a signal, an internal error, or for want of memory.
  kInvalid,     ///< It could not begin.
};
std::string_view Name(Outcome outcome);
std::optional<Outcome> OutcomeOf(std::string_view name);

/// What a layer cost in one run. The times differ from run to run, the rest does not.
struct LayerRecord {
  std::string name;
  std::string reasoner;
  std::uint64_t decisions = 0;
  double inferences = 0;  ///< Mean of a decision.
  std::uint64_t budget_hits = 0;
  std::uint64_t assumed_by_bound = 0;
  std::uint64_t faults = 0;
  double mean_us = 0;
  double p50_us = 0;
  double p99_us = 0;
  friend bool operator==(const LayerRecord&, const LayerRecord&) = default;
};

/// What is kept of a run.
struct RunRecord {
  RunKey key;
  Outcome outcome = Outcome::kInvalid;
  std::string message;
  std::string command;    ///< That repeats it.
  double time_s = 0;      ///< In the world.
  double duration_s = 0;  ///< How long it might have lasted there.
  double distance_m = 0;
  std::uint64_t collisions = 0;
  std::vector<LayerRecord> layers;
  std::string trajectory;  ///< "1 2.5,3 4.25,3;2 9,9": floors, and the places there, m.
  double wall_s = 0;       ///< Of the process; differs from run to run, as does cpu_s.
  double cpu_s = 0;
  friend bool operator==(const RunRecord&, const RunRecord&) = default;
};

/// From what the process of a run printed and how it ended.
RunRecord Judge(const PlannedRun& run, const process::ChildResult& child);

/// What a person types to see a run end as it did: where a limit ended it, within these.
std::string RepeatOf(const RunRecord& record, const RunLimits& limits);

/// One line of JSON, and back; nothing for a line that is none.
std::string ToLine(const RunRecord& record);
std::optional<RunRecord> FromLine(std::string_view line);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_RUNS_RUN_RECORD_H_
