// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_STATISTICS_MCNEMAR_H_
#define LATCHWORK_APPS_COMPARE_STATISTICS_MCNEMAR_H_

#include <cstddef>

namespace latchwork::compare {

/// Of pairs of runs that share a seed, those that only one of two agents brought to its goal.
struct Discordant {
  std::size_t only_first = 0;
  std::size_t only_second = 0;
};

/// How likely pairs at least as unequal are when both agents are equally good: two-sided, exact, in
/// [0, 1]; 1 when there are none. Source: McNemar 1947, with the binomial distribution for the
/// exact form.
double McNemarExact(const Discordant& pairs);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_STATISTICS_MCNEMAR_H_
