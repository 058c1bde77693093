// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/atom.h"

#include <algorithm>

#include "core/logic/print.h"

namespace latchwork::logic {

Atom::Atom(Symbol predicate, std::span<const Term> arguments)
    : predicate_(predicate), arity_(arguments.size()) {
  if (arity_ <= kInlineArguments) {
    std::copy(arguments.begin(), arguments.end(), inline_.begin());
  } else {
    more_.assign(arguments.begin(), arguments.end());
  }
}

bool Atom::is_ground() const {
  const auto all = arguments();
  return std::all_of(all.begin(), all.end(), [](const Term& term) { return term.is_ground(); });
}

bool operator==(const Atom& a, const Atom& b) {
  const auto x = a.arguments();
  const auto y = b.arguments();
  return a.predicate_ == b.predicate_ && std::equal(x.begin(), x.end(), y.begin(), y.end());
}

std::strong_ordering operator<=>(const Atom& a, const Atom& b) {
  if (const auto by_name = a.predicate_ <=> b.predicate_; std::is_neq(by_name)) return by_name;
  if (const auto by_arity = a.arity_ <=> b.arity_; std::is_neq(by_arity)) return by_arity;
  const auto x = a.arguments();
  const auto y = b.arguments();
  return std::lexicographical_compare_three_way(x.begin(), x.end(), y.begin(), y.end());
}

bool IsEquation(const Atom& atom) { return atom.arity() == 2 && atom.predicate().name() == "="; }

void AppendAtom(std::string& text, const Atom& atom, std::span<const std::string> names) {
  AppendLiteral(text, true, atom, names);
}

void AppendLiteral(std::string& text, bool positive, const Atom& atom,
                   std::span<const std::string> names) {
  if (IsEquation(atom)) {
    AppendTerm(text, atom.argument(0), names);
    text += positive ? " = " : " != ";
    AppendTerm(text, atom.argument(1), names);
    return;
  }
  if (!positive) text += "~ ";
  AppendSymbol(text, atom.predicate());
  std::string_view separator = "(";
  for (const Term& argument : atom.arguments()) {
    text += separator;
    AppendTerm(text, argument, names);
    separator = ", ";
  }
  if (atom.arity() > 0) text += ')';
}

std::string ToString(const Atom& atom, std::span<const std::string> variable_names) {
  std::string text;
  AppendAtom(text, atom, variable_names);
  return text;
}

std::string ToString(const PredicateName& name) {
  std::string text;
  AppendSymbol(text, name.symbol);
  return text + '/' + std::to_string(name.arity);
}

}  // namespace latchwork::logic
