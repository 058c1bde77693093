// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_REPORT_FINDINGS_H_
#define LATCHWORK_APPS_COMPARE_REPORT_FINDINGS_H_

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "apps/compare/experiment/experiment.h"
#include "apps/compare/runs/run_record.h"
#include "apps/compare/statistics/comparison.h"

namespace latchwork::compare {

using Records = std::map<RunKey, RunRecord>;

/// How one contender fared in one scenario.
struct Tally {
  std::string scenario;
  std::string contender;
  std::size_t runs = 0;
  std::map<Outcome, std::size_t> outcomes;
  double limit_s = 0;       ///< How long a run of the scenario may last; 0: no run told.
  double mean_time_s = 0;   ///< In the world, of the runs that reached the goal.
  double restricted_s = 0;  ///< Mean of all; what failed counts the limit.
  double par2_s = 0;        ///< Of all; what failed counts twice the limit.
};

/// The first contender against another, over all seeds of a scenario that both have run.
struct Duel {
  std::string scenario;
  std::string first;
  std::string second;
  double limit_s = 0;  ///< How long a run may last; 0: no run told, times say nothing.
  Comparison comparison;
};

/// What an experiment showed so far.
struct Findings {
  std::vector<Tally> tallies;
  std::vector<Duel> duels;  ///< Corrected together.
  std::vector<RunRecord> failures;
};

/// How long a run of the scenario may last, s; 0 when none of them told.
double LimitOf(const Records& records, const std::string& scenario);

Findings Evaluate(const Experiment& experiment, const Records& records);

/// How often a run ended so.
std::size_t CountOf(const Tally& tally, Outcome outcome);

/// The findings for people: verdicts in words first, then tables, then each failure with the
/// command that repeats it.
std::string ToText(const Experiment& experiment, const Findings& findings);

/// All runs, one line each, with a header.
std::string ToCsv(const Records& records, const RunLimits& limits);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_REPORT_FINDINGS_H_
