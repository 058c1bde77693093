// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_CHECK_PROOF_CLAUSE_MATCH_H_
#define LATCHWORK_APPS_CHECK_PROOF_CLAUSE_MATCH_H_

#include <cstdint>
#include <vector>

#include "apps/check_proof/normal_form.h"
#include "latchwork/logic/clause.h"

namespace latchwork::check_proof {

enum class Verdict : std::uint8_t { kYes, kNo, kTooHard };

/// Whether the clause can be read off a formula without existential quantifiers: by choosing from
/// every conjunction one part, and for universal variables terms, such that all literals that are
/// left stand in the clause. Covers instances, and merging of literals.
Verdict MatchesClause(const Tree& formula, const std::vector<logic::Literal>& clause);

}  // namespace latchwork::check_proof

#endif  // LATCHWORK_APPS_CHECK_PROOF_CLAUSE_MATCH_H_
