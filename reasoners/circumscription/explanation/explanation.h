// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_EXPLANATION_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_EXPLANATION_H_

#include <string>
#include <vector>

#include "latchwork/sdk/decision.h"
#include "reasoners/circumscription/explanation/near_miss.h"

namespace latchwork::circumscription {

/// Why something is not concluded (a goal; or the contrary of a default, which therefore was made),
/// or, where it is, how: then a default is retracted, and the derivation names the facts of
/// latches that did it, with their ports.
struct Explanation {
  std::string subject;  ///< An atom in TPTP syntax.
  bool holds = false;
  std::vector<NearMiss> misses;  ///< Where it does not hold: the nearest first.
  sdk::Derivation derivation;    ///< Where it holds.
};

/// For people, one line each.
std::string ToText(const Explanation& explanation);
/// {"subject": ..., "holds": ..., "because": [{"conclusion", "kind", "source", "line"}]} or
/// "misses" in place of "because": [{"clause", "line", "met", "premises", "lacks"}].
std::string ToJson(const Explanation& explanation);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_EXPLANATION_H_
