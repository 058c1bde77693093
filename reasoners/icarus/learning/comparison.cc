// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/learning/comparison.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "latchwork/sdk/random.h"

namespace latchwork::icarus {

Interval BootstrapInterval(std::span<const double> differences, std::uint64_t seed) {
  constexpr std::size_t kSamples = 4000;
  const std::size_t count = differences.size();
  if (count == 0) return {};
  const auto size = static_cast<double>(count);
  const sdk::RandomStream stream(seed, "icarus.bootstrap");
  std::vector<double> means;
  means.reserve(kSamples);
  for (std::size_t sample = 0; sample < kSamples; ++sample) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += differences[stream.Index(count, sample, i)];
    means.push_back(sum / size);
  }
  std::sort(means.begin(), means.end());
  const double mean = std::accumulate(differences.begin(), differences.end(), 0.0) / size;
  return {mean, means[kSamples / 40], means[kSamples - 1 - kSamples / 40]};
}

}  // namespace latchwork::icarus
