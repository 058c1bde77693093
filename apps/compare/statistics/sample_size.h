// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_STATISTICS_SAMPLE_SIZE_H_
#define LATCHWORK_APPS_COMPARE_STATISTICS_SAMPLE_SIZE_H_

#include <cstddef>

namespace latchwork::compare {

/// How sure an experiment shall be: of no false finding (level), of finding what is there (power).
struct Demand {
  double level = 0.05;  ///< Two-sided, in (0, 1).
  double power = 0.8;   ///< In (0, 1).
};

/// Pairs of runs that McNemar's exact test needs to find the difference between two agents of which
/// only the first reaches its goal in `only_first` of the pairs, only the second in `only_second`
/// (shares, their sum at most 1). 0: the shares are equal, or more than 100,000 pairs are needed.
std::size_t PairsForSuccess(double only_first, double only_second, const Demand& demand);

/// Pairs that the signed-rank test needs to find a mean difference of `shift` standard deviations
/// of the differences, were those normal. 0: `shift` is 0. Source: Noether 1987.
std::size_t PairsForTime(double shift, const Demand& demand);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_STATISTICS_SAMPLE_SIZE_H_
