// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/statistics/bootstrap.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "latchwork/sdk/random.h"

namespace latchwork::compare {
namespace {

constexpr std::size_t kSamples = 4000;
constexpr double kTail = 0.025;

std::vector<double> SampledMeans(std::span<const double> values, std::uint64_t seed) {
  const sdk::RandomStream stream(seed, "compare.bootstrap");
  std::vector<double> means(kSamples);
  for (std::size_t sample = 0; sample < kSamples; ++sample) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      sum += values[stream.Index(values.size(), sample, i)];
    }
    means[sample] = sum / static_cast<double>(values.size());
  }
  std::sort(means.begin(), means.end());
  return means;
}

/// How fast the spread of the mean changes with it, from the means without one value each.
double Acceleration(std::span<const double> values, double mean) {
  double squares = 0;
  double cubes = 0;
  for (const double value : values) {
    const double influence = value - mean;
    squares += influence * influence;
    cubes += influence * influence * influence;
  }
  return squares == 0 ? 0 : cubes / (6 * std::pow(squares, 1.5));
}

}  // namespace

Interval BootstrapInterval(std::span<const double> differences, std::uint64_t seed) {
  if (differences.empty()) return {};
  const double mean = std::accumulate(differences.begin(), differences.end(), 0.0) /
                      static_cast<double>(differences.size());
  const std::vector<double> means = SampledMeans(differences, seed);
  const auto rank = [&](double value) {
    const auto [first, last] = std::equal_range(means.begin(), means.end(), value);
    return (static_cast<double>(first - means.begin()) +
            static_cast<double>(last - means.begin())) /
           2;
  };
  const boost::math::normal normal;
  const double below = std::clamp(rank(mean) / kSamples, 1.0 / kSamples, 1 - 1.0 / kSamples);
  const double bias = boost::math::quantile(normal, below);
  const double acceleration = Acceleration(differences, mean);
  const auto bound = [&](double tail) {
    const double shifted = bias + boost::math::quantile(normal, tail);
    const double level = boost::math::cdf(normal, bias + shifted / (1 - acceleration * shifted));
    const auto index = static_cast<std::size_t>(std::lround(level * (kSamples - 1)));
    return means[std::min(index, kSamples - 1)];
  };
  return {mean, bound(kTail), bound(1 - kTail)};
}

}  // namespace latchwork::compare
