// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_STATISTICS_BOOTSTRAP_H_
#define LATCHWORK_APPS_COMPARE_STATISTICS_BOOTSTRAP_H_

#include <cstdint>
#include <span>

namespace latchwork::compare {

/// A mean, and what it lies between with a confidence of 95 %.
struct Interval {
  double mean = 0;
  double low = 0;
  double high = 0;
};

/// The mean of paired differences and its bootstrap interval, bias-corrected and accelerated, of
/// 4000 samples drawn with replacement. Deterministic in `seed`. No differences: all zero. Source:
/// Efron and Tibshirani, An introduction to the bootstrap (1993), section 14.3.
Interval BootstrapInterval(std::span<const double> differences, std::uint64_t seed);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_STATISTICS_BOOTSTRAP_H_
