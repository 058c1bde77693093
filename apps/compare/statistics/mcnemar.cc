// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/statistics/mcnemar.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>

namespace latchwork::compare {

double McNemarExact(const Discordant& pairs) {
  const std::size_t all = pairs.only_first + pairs.only_second;
  if (all == 0) return 1;
  const boost::math::binomial fair(static_cast<double>(all), 0.5);
  const auto fewer = static_cast<double>(std::min(pairs.only_first, pairs.only_second));
  return std::min(1.0, 2 * boost::math::cdf(fair, fewer));
}

}  // namespace latchwork::compare
