// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/statistics/comparison.h"

#include <algorithm>
#include <cmath>

#include "apps/compare/statistics/holm.h"
#include "apps/compare/statistics/shares.h"

namespace latchwork::compare {
namespace {

double Restricted(const RunScore& run, double limit) {
  return run.reached ? std::min(run.time, limit) : limit;
}

/// Times are multiples of a tick; the same difference shall not differ in its last bits.
double Rounded(double seconds) { return std::round(seconds * 1e6) / 1e6; }

double Par2(std::span<const RunScore> runs, double limit) {
  if (runs.empty()) return 0;
  double sum = 0;
  for (const RunScore& run : runs) sum += run.reached ? std::min(run.time, limit) : 2 * limit;
  return sum / static_cast<double>(runs.size());
}

std::size_t CountReached(std::span<const RunScore> runs) {
  return static_cast<std::size_t>(std::ranges::count(runs, true, &RunScore::reached));
}

}  // namespace

Comparison Compare(std::span<const RunScore> first, std::span<const RunScore> second, double limit,
                   std::uint64_t seed) {
  Comparison result;
  result.pairs = std::min(first.size(), second.size());
  std::vector<double> differences;
  for (std::size_t i = 0; i < result.pairs; ++i) {
    differences.push_back(Rounded(Restricted(first[i], limit) - Restricted(second[i], limit)));
    if (first[i].reached && !second[i].reached) ++result.discordant.only_first;
    if (!first[i].reached && second[i].reached) ++result.discordant.only_second;
  }
  result.first_reached = CountReached(first.first(result.pairs));
  result.second_reached = CountReached(second.first(result.pairs));
  result.p_success = McNemarExact(result.discordant);
  result.success = DifferenceOfShares(result.discordant, result.pairs);
  result.difference = BootstrapInterval(differences, seed);
  result.first_par2 = Par2(first.first(result.pairs), limit);
  result.second_par2 = Par2(second.first(result.pairs), limit);
  result.times = WilcoxonSignedRanks(differences);
  result.p_success_corrected = result.p_success;
  result.p_times_corrected = result.times.p;
  return result;
}

void CorrectTogether(std::span<Comparison> comparisons) {
  std::vector<double> p_values;
  for (const Comparison& each : comparisons) {
    p_values.push_back(each.p_success);
    p_values.push_back(each.times.p);
  }
  const std::vector<double> corrected = Holm(p_values);
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    comparisons[i].p_success_corrected = corrected[2 * i];
    comparisons[i].p_times_corrected = corrected[2 * i + 1];
  }
}

std::string_view Name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kFirstBetter:
      return "the first is better";
    case Verdict::kSecondBetter:
      return "the second is better";
    case Verdict::kNoDifferenceShown:
      break;
  }
  return "no difference shown";
}

Verdict OnSuccess(const Comparison& comparison, double level) {
  if (comparison.p_success_corrected > level) return Verdict::kNoDifferenceShown;
  return comparison.discordant.only_first > comparison.discordant.only_second
             ? Verdict::kFirstBetter
             : Verdict::kSecondBetter;
}

Verdict OnTime(const Comparison& comparison, double level) {
  if (comparison.p_times_corrected > level) return Verdict::kNoDifferenceShown;
  return comparison.times.effect < 0 ? Verdict::kFirstBetter : Verdict::kSecondBetter;
}

}  // namespace latchwork::compare
