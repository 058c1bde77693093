// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_EXPLANATION_H_
#define LATCHWORK_SDK_EXPLANATION_H_

#include <cstddef>
#include <string>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/sdk/decision.h"

namespace latchwork::sdk {

/// How near a clause came to concluding something, and what it lacks.
struct NearMiss {
  std::string clause;
  logic::SourcePlace place;
  std::size_t met = 0;       ///< Premises that hold together.
  std::size_t premises = 0;  ///< All of them.
  std::string lacks;  ///< The next one, as far as it is known: `near(obj(3))`, `$less(2, 1)`.
};

/// Why something is not concluded (a goal; or the contrary of a default, which therefore was made),
/// or, where it is, how: then a default is retracted, and the derivation names the facts of
/// latches that did it, with their ports.
struct Explanation {
  std::string subject;  ///< An atom in TPTP syntax.
  bool holds = false;
  std::vector<NearMiss> misses;  ///< Where it does not hold: the nearest first.
  Derivation derivation;         ///< Where it holds; else a minimal world without it, if known.
};

/// For people, a line for each step.
std::string ToText(const Derivation& derivation);
std::string ToText(const Explanation& explanation);
/// {"subject": ..., "holds": ..., "because": [{"conclusion", "kind", "source", "line"}]} or
/// "misses": [{"clause", "line", "met", "premises", "lacks"}] and "world", written as "because".
std::string ToJson(const Explanation& explanation);

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_EXPLANATION_H_
