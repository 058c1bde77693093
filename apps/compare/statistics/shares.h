// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_STATISTICS_SHARES_H_
#define LATCHWORK_APPS_COMPARE_STATISTICS_SHARES_H_

#include <cstddef>

#include "apps/compare/statistics/bootstrap.h"
#include "apps/compare/statistics/mcnemar.h"

namespace latchwork::compare {

/// `count` of `all` as a share and its score interval of 95 %. None at all: 0, from 0 to 1. Source:
/// Wilson 1927; Newcombe 1998.
Interval Share(std::size_t count, std::size_t all);

/// By how much the first share of a paired sample is larger than the second, with its interval of
/// 95 %. No pairs: 0, from -1 to 1. Source: Agresti and Min 2005 (Wald's interval after half a
/// pair is added to each of the four cells).
Interval DifferenceOfShares(const Discordant& discordant, std::size_t pairs);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_STATISTICS_SHARES_H_
