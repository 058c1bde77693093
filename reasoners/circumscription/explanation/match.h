// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_MATCH_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_MATCH_H_

#include "latchwork/logic/atom.h"

namespace latchwork::circumscription {

/// Whether `fact` is an instance of `pattern`: one term for each of its variables.
bool Matches(const logic::Atom& pattern, const logic::Fact& fact);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXPLANATION_MATCH_H_
