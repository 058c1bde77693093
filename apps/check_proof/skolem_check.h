// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_CHECK_PROOF_SKOLEM_CHECK_H_
#define LATCHWORK_APPS_CHECK_PROOF_SKOLEM_CHECK_H_

#include <set>
#include <string>

#include "apps/check_proof/normal_form.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::check_proof {

/// Whether `after` is `before` with every existential variable replaced by a term f(X, ...): `f`
/// one of the `functions`, for no other variable; X, ... universal variables, all that the formula
/// below the quantifier depends on among them. Of a conjunction or disjunction below the quantifier
/// only the parts with the variable count: it could be moved there. Gives what is wrong, or "".
std::string CheckSkolemization(const Tree& before, const Tree& after,
                               const std::set<logic::Symbol>& functions);

}  // namespace latchwork::check_proof

#endif  // LATCHWORK_APPS_CHECK_PROOF_SKOLEM_CHECK_H_
