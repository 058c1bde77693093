// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/statistics/wilcoxon.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

namespace latchwork::compare {
namespace {

constexpr std::size_t kMostExact = 60;

/// Ranks are doubled, so that shared ones are whole numbers.
struct Ranked {
  std::vector<std::uint64_t> ranks;
  std::uint64_t positive = 0;  ///< Sum of the ranks of positive differences.
  std::uint64_t all = 0;
  double ties = 0;  ///< Sum of t^3 - t over groups of t equal differences.
};

Ranked Rank(std::vector<double> differences) {
  std::sort(differences.begin(), differences.end(),
            [](double a, double b) { return std::abs(a) < std::abs(b); });
  Ranked ranked;
  for (std::size_t first = 0; first < differences.size();) {
    std::size_t end = first;
    while (end < differences.size() && std::abs(differences[end]) == std::abs(differences[first])) {
      ++end;
    }
    const std::uint64_t rank = first + 1 + end;
    for (std::size_t i = first; i < end; ++i) {
      ranked.ranks.push_back(rank);
      ranked.all += rank;
      if (differences[i] > 0) ranked.positive += rank;
    }
    const auto size = static_cast<double>(end - first);
    ranked.ties += size * size * size - size;
    first = end;
  }
  return ranked;
}

/// How likely a sum of positive ranks of at most `most` is when each sign is a coin's.
double LowerTail(const std::vector<std::uint64_t>& ranks, std::uint64_t all, std::uint64_t most) {
  std::vector<double> share(all + 1, 0);
  share[0] = 1;
  std::uint64_t reached = 0;
  for (const std::uint64_t rank : ranks) {
    reached += rank;
    for (std::uint64_t sum = reached + 1; sum-- > 0;) {
      share[sum] = (share[sum] + (sum >= rank ? share[sum - rank] : 0)) / 2;
    }
  }
  double tail = 0;
  for (std::uint64_t sum = 0; sum <= most; ++sum) tail += share[sum];
  return tail;
}

double Approximate(const Ranked& ranked) {
  const auto count = static_cast<double>(ranked.ranks.size());
  const double variance = count * (count + 1) * (2 * count + 1) / 24 - ranked.ties / 48;
  const double distance =
      std::abs(static_cast<double>(ranked.positive) / 2 - static_cast<double>(ranked.all) / 4);
  const double score = std::max(0.0, distance - 0.5) / std::sqrt(variance);
  return std::min(1.0, 2 * boost::math::cdf(boost::math::complement(boost::math::normal(), score)));
}

}  // namespace

SignedRanks WilcoxonSignedRanks(std::span<const double> differences) {
  std::vector<double> counted;
  std::copy_if(differences.begin(), differences.end(), std::back_inserter(counted),
               [](double difference) { return difference != 0; });
  SignedRanks result;
  result.counted = counted.size();
  if (counted.empty()) return result;
  const Ranked ranked = Rank(std::move(counted));
  const std::uint64_t negative = ranked.all - ranked.positive;
  result.effect = (static_cast<double>(ranked.positive) - static_cast<double>(negative)) /
                  static_cast<double>(ranked.all);
  result.exact = result.counted <= kMostExact;
  result.p = result.exact ? std::min(1.0, 2 * LowerTail(ranked.ranks, ranked.all,
                                                        std::min(ranked.positive, negative)))
                          : Approximate(ranked);
  return result;
}

}  // namespace latchwork::compare
