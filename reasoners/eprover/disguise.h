// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_EPROVER_DISGUISE_H_
#define LATCHWORK_EPROVER_DISGUISE_H_

#include <string>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::eprover {

/// Numbers go to E as distinct objects, `"#1.5"`, which are unequal as numbers are and for which E
/// has no theory of its own. Distinct objects that begin with `#` get another.
logic::Term Disguise(const logic::Term& term, logic::SymbolTable& symbols);
logic::Atom Disguise(const logic::Atom& atom, logic::SymbolTable& symbols);
logic::Term Undisguise(const logic::Term& term, logic::SymbolTable& symbols);
logic::Atom Undisguise(const logic::Atom& atom, logic::SymbolTable& symbols);

/// `cnf(name, axiom, (...)).` and a new line.
std::string Axiom(const logic::Clause& clause, logic::SymbolTable& symbols);
/// The same for a fact, or its denial.
std::string Axiom(const logic::Literal& literal, logic::SymbolTable& symbols);

}  // namespace latchwork::eprover

#endif  // LATCHWORK_EPROVER_DISGUISE_H_
