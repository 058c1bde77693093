// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/statistics/holm.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace latchwork::compare {

std::vector<double> Holm(std::span<const double> p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  std::vector<double> corrected(p_values.size());
  double greatest = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto factor = static_cast<double>(order.size() - i);
    greatest = std::max(greatest, std::min(1.0, factor * p_values[order[i]]));
    corrected[order[i]] = greatest;
  }
  return corrected;
}

}  // namespace latchwork::compare
