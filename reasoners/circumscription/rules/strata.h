// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_STRATA_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_STRATA_H_

#include <cstddef>
#include <utility>
#include <vector>

namespace latchwork::circumscription {

/// Which relation needs which: (needed, needing).
using Dependencies = std::vector<std::pair<std::size_t, std::size_t>>;

struct StrataOf {
  std::vector<std::size_t> stratum;  ///< By relation; what is needed comes first.
  std::vector<bool> is_recursive;    ///< By stratum.
};

/// The strongly connected components of the dependencies in topological order (Tarjan 1972).
StrataOf FindStrata(std::size_t relations, const Dependencies& dependencies);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_STRATA_H_
