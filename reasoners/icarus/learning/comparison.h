// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_COMPARISON_H_
#define LATCHWORK_ICARUS_COMPARISON_H_

#include <cstdint>
#include <span>

namespace latchwork::icarus {

struct Interval {
  double mean = 0;
  double low = 0;
  double high = 0;
};

/// The mean of paired differences and its bootstrap interval of 95 %: the quantiles of the means
/// of 4000 samples drawn from them with replacement. Deterministic in `seed`. No differences: all
/// zero. Source: Efron and Tibshirani, An introduction to the bootstrap (1993), section 13.3.
Interval BootstrapInterval(std::span<const double> differences, std::uint64_t seed);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_COMPARISON_H_
