// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/statistics/sample_size.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "apps/compare/statistics/mcnemar.h"

namespace latchwork::compare {
namespace {

using boost::math::binomial;

constexpr std::size_t kMostPairs = 100'000;

/// Of `pairs` discordant pairs, the most that may be on the weaker side in a finding; -1: no
/// number.
double Critical(std::size_t pairs, double level) {
  std::size_t none = 0;
  std::size_t too_many = pairs / 2 + 1;
  while (none < too_many) {
    const std::size_t middle = (none + too_many) / 2;
    if (McNemarExact({middle, pairs - middle}) <= level) {
      none = middle + 1;
    } else {
      too_many = middle;
    }
  }
  return static_cast<double>(none) - 1;
}

/// The chance of a finding when `share` of the discordant pairs are on one side.
double PowerOfDiscordant(std::size_t pairs, double share, double level) {
  const double critical = Critical(pairs, level);
  if (critical < 0) return 0;
  const binomial side(static_cast<double>(pairs), share);
  const double other = static_cast<double>(pairs) - critical - 1;
  return cdf(side, critical) + cdf(complement(side, other));
}

double Power(std::size_t pairs, double discordant, double share, double level) {
  const auto count = static_cast<double>(pairs);
  const binomial number(count, discordant);
  const double mean = count * discordant;
  const double reach = 8 * std::sqrt(mean) + 8;
  const auto first = static_cast<std::size_t>(std::max(0.0, mean - reach));
  const auto last = static_cast<std::size_t>(std::min(count, mean + reach));
  double power = 0;
  for (std::size_t d = first; d <= last; ++d) {
    power += pdf(number, static_cast<double>(d)) * PowerOfDiscordant(d, share, level);
  }
  return power;
}

double Quantile(double probability) {
  return boost::math::quantile(boost::math::normal(), probability);
}

}  // namespace

std::size_t PairsForSuccess(double only_first, double only_second, const Demand& demand) {
  const double discordant = std::min(1.0, only_first + only_second);
  if (only_first == only_second) return 0;
  const double share = only_first / discordant;
  const auto suffices = [&](std::size_t pairs) {
    return Power(pairs, discordant, share, demand.level) >= demand.power;
  };
  std::size_t enough = 1;
  while (!suffices(enough)) {
    if (enough == kMostPairs) return 0;
    enough = std::min(2 * enough, kMostPairs);
  }
  std::size_t too_few = enough / 2;
  while (enough - too_few > 1) {
    const std::size_t middle = (too_few + enough) / 2;
    (suffices(middle) ? enough : too_few) = middle;
  }
  return enough;
}

std::size_t PairsForTime(double shift, const Demand& demand) {
  if (shift == 0) return 0;
  const double above =
      boost::math::cdf(boost::math::normal(), std::abs(shift) * std::sqrt(2.0)) - 0.5;
  const double sum = Quantile(1 - demand.level / 2) + Quantile(demand.power);
  return static_cast<std::size_t>(std::ceil(sum * sum / (3 * above * above)));
}

}  // namespace latchwork::compare
