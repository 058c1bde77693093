// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_STATISTICS_COMPARISON_H_
#define LATCHWORK_APPS_COMPARE_STATISTICS_COMPARISON_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "apps/compare/statistics/bootstrap.h"
#include "apps/compare/statistics/mcnemar.h"
#include "apps/compare/statistics/wilcoxon.h"

namespace latchwork::compare {

/// How one agent fared in one run. No run is left out: one that fails has the time limit.
struct RunScore {
  bool reached = false;
  double time = 0;  ///< Of the quantity that is compared, until the goal; of failures meaningless.
};

/// Two agents over the same scenarios and seeds.
struct Comparison {
  std::size_t pairs = 0;
  std::size_t first_reached = 0;
  std::size_t second_reached = 0;
  Discordant discordant;
  double p_success = 1;   ///< McNemar.
  Interval success;       ///< Share of reached goals, first minus second.
  Interval difference;    ///< Of restricted times, first minus second; failures count the limit.
  double first_par2 = 0;  ///< Mean time, failures counted as twice the limit.
  double second_par2 = 0;
  SignedRanks times;               ///< Of the same differences.
  double p_success_corrected = 1;  ///< After Holm; see CorrectTogether.
  double p_times_corrected = 1;
};

/// `first` and `second` are in the order of the pairs. `limit` is the time limit of all runs.
Comparison Compare(std::span<const RunScore> first, std::span<const RunScore> second, double limit,
                   std::uint64_t seed);

/// Corrects the p values of comparisons that are reported together, all of both kinds as one
/// family.
void CorrectTogether(std::span<Comparison> comparisons);

enum class Verdict : std::uint8_t { kNoDifferenceShown, kFirstBetter, kSecondBetter };
std::string_view Name(Verdict verdict);

/// At this level, from the corrected p values.
Verdict OnSuccess(const Comparison& comparison, double level);
Verdict OnTime(const Comparison& comparison, double level);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_STATISTICS_COMPARISON_H_
