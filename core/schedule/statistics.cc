// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/schedule/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string_view>

namespace latchwork::schedule {
namespace {

double NearestRank(const std::vector<double>& sorted, std::size_t percent) {
  const std::size_t rank = (sorted.size() * percent + 99) / 100;
  return sorted[std::max<std::size_t>(rank, 1) - 1];
}

}  // namespace

Spread Describe(std::vector<double> sample) {
  Spread spread;
  if (sample.empty()) return spread;
  const auto count = static_cast<double>(sample.size());
  spread.mean = std::accumulate(sample.begin(), sample.end(), 0.0) / count;
  double squares = 0;
  for (const double value : sample) squares += (value - spread.mean) * (value - spread.mean);
  if (sample.size() > 1) spread.sd = std::sqrt(squares / (count - 1));
  std::sort(sample.begin(), sample.end());
  spread.p50 = NearestRank(sample, 50);
  spread.p99 = NearestRank(sample, 99);
  spread.max = sample.back();
  return spread;
}

std::string_view Name(RunResult::State state) {
  switch (state) {
    case RunResult::State::kReached:
      return "reached";
    case RunResult::State::kNotReached:
      return "not reached";
    case RunResult::State::kFailed:
      return "failed";
    case RunResult::State::kStopped:
      return "stopped";
  }
  return "";
}

}  // namespace latchwork::schedule
