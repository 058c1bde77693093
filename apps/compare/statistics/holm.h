// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_STATISTICS_HOLM_H_
#define LATCHWORK_APPS_COMPARE_STATISTICS_HOLM_H_

#include <span>
#include <vector>

namespace latchwork::compare {

/// The p values of tests that are made together, corrected so that among them the chance of any
/// false finding stays at the level of one test. In the order given. Source: Holm 1979.
std::vector<double> Holm(std::span<const double> p_values);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_STATISTICS_HOLM_H_
