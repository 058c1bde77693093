// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/statistics/shares.h"

#include <algorithm>
#include <cmath>

namespace latchwork::compare {
namespace {

constexpr double kZ = 1.959963984540054;  // of 95 % in a normal distribution

}  // namespace

Interval Share(std::size_t count, std::size_t all) {
  if (all == 0) return {0, 0, 1};
  const auto n = static_cast<double>(all);
  const double share = static_cast<double>(count) / n;
  const double middle = share + kZ * kZ / (2 * n);
  const double half = kZ * std::sqrt(share * (1 - share) / n + kZ * kZ / (4 * n * n));
  const double whole = 1 + kZ * kZ / n;
  return {share, std::clamp((middle - half) / whole, 0.0, share),
          std::clamp((middle + half) / whole, share, 1.0)};
}

Interval DifferenceOfShares(const Discordant& discordant, std::size_t pairs) {
  if (pairs == 0) return {0, -1, 1};
  const auto b = static_cast<double>(discordant.only_first);
  const auto c = static_cast<double>(discordant.only_second);
  const double n = static_cast<double>(pairs) + 2;
  const double mean = (b - c) / static_cast<double>(pairs);
  const double middle = (b - c) / n;
  const double half = kZ * std::sqrt(std::max(0.0, b + c + 1 - (b - c) * (b - c) / n)) / n;
  return {mean, std::clamp(middle - half, -1.0, mean), std::clamp(middle + half, mean, 1.0)};
}

}  // namespace latchwork::compare
