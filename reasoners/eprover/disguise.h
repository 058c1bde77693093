// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_EPROVER_DISGUISE_H_
#define LATCHWORK_EPROVER_DISGUISE_H_

#include <string>
#include <string_view>

#include "latchwork/logic/clause.h"

namespace latchwork::eprover {

/// Numbers go to E as distinct objects, `"#1.5"`, which are unequal as numbers are and for which E
/// has no theory of its own. Distinct objects that begin with `#` get another. All of it is done in
/// TPTP text, as printed here and by E: no symbol is interned for a number that came by once.
std::string Disguise(std::string_view text);
std::string Undisguise(std::string_view text);

/// `cnf(name, axiom, (...)).` and a new line.
std::string Axiom(const logic::Clause& clause);
/// The same for a fact, or its denial.
std::string Axiom(const logic::Literal& literal);

}  // namespace latchwork::eprover

#endif  // LATCHWORK_EPROVER_DISGUISE_H_
