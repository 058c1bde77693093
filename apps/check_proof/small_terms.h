// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_CHECK_PROOF_SMALL_TERMS_H_
#define LATCHWORK_APPS_CHECK_PROOF_SMALL_TERMS_H_

#include <cstddef>
#include <map>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/clause.h"

namespace latchwork::check_proof {

/// Of variables; a value may hold variables that have values themselves.
using Bindings = std::map<logic::Variable, logic::Term>;

bool IsEquation(const logic::Literal& literal);

/// Symbols; `depth` becomes the number of terms within each other.
std::size_t Size(const logic::Term& term, std::size_t& depth);

logic::Term Apply(const logic::Term& term, const Bindings& bindings);
logic::Atom Apply(const logic::Atom& atom, const Bindings& bindings);

bool Unify(const logic::Term& left, const logic::Term& right, Bindings& bindings);
bool Unify(const logic::Atom& a, const logic::Atom& b, Bindings& bindings);

/// Whether values for the variables of `pattern` make it equal to `term`, whose variables are taken
/// for constants. Where not, `bindings` is left in any state.
bool Match(const logic::Term& pattern, const logic::Term& term, Bindings& bindings);
bool Match(const logic::Atom& pattern, const logic::Atom& atom, Bindings& bindings);

bool Contains(const logic::Term& term, const logic::Term& part);

/// Knuth and Bendix's ordering with weight 1 for every symbol.
bool IsGreater(const logic::Term& a, const logic::Term& b);
bool IsGreater(const logic::Atom& a, const logic::Atom& b);

}  // namespace latchwork::check_proof

#endif  // LATCHWORK_APPS_CHECK_PROOF_SMALL_TERMS_H_
