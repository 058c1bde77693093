// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_PRINT_H_
#define LATCHWORK_LOGIC_PRINT_H_

#include <span>
#include <string>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/formula.h"
#include "latchwork/logic/term.h"

namespace latchwork::logic {

void AppendVariable(std::string& text, Variable variable, std::span<const std::string> names);
void AppendSymbol(std::string& text, Symbol symbol);
void AppendTerm(std::string& text, const Term& term, std::span<const std::string> names);
void AppendAtom(std::string& text, const Atom& atom, std::span<const std::string> names);
/// The atom or its negation; a negated equation as `a != b`.
void AppendLiteral(std::string& text, bool positive, const Atom& atom,
                   std::span<const std::string> names);

/// The names themselves where each is a variable's name and its own; else names made from them.
std::vector<std::string> DistinctNames(const std::vector<std::string>& names);

/// Whether this is the built-in equality.
bool IsEquation(const Atom& atom);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_PRINT_H_
