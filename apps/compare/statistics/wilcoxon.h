// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_STATISTICS_WILCOXON_H_
#define LATCHWORK_APPS_COMPARE_STATISTICS_WILCOXON_H_

#include <cstddef>
#include <span>

namespace latchwork::compare {

/// What the signed-rank test says of paired differences.
struct SignedRanks {
  double p = 1;       ///< Two-sided, that the differences are symmetric about 0.
  double effect = 0;  ///< Matched-pairs rank-biserial correlation, -1 to 1; > 0: mostly positive.
  std::size_t counted =
      0;              ///< Differences that are not 0; the others say nothing and are left out.
  bool exact = true;  ///< By counting all signs; else by the normal approximation.
};

/// Equal differences share their mean rank. Exact up to 60 differences, ties or not; beyond that
/// the normal approximation, corrected for ties and continuity. The differences must be finite.
/// Source: Wilcoxon 1945; Kerby 2014 for the effect.
SignedRanks WilcoxonSignedRanks(std::span<const double> differences);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_STATISTICS_WILCOXON_H_
