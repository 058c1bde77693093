// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/computed_conclusions.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace latchwork::pttp {
namespace {

using logic::Clause;
using logic::Literal;
using logic::Term;

bool IsUninterpreted(const Literal& literal) {
  const std::string_view name = literal.atom.predicate().name();
  return name != "=" && !name.starts_with('$');
}

void Flatten(Clause& clause, std::size_t conclusion, logic::Symbol equality) {
  const logic::Atom atom = clause.literals[conclusion].atom;
  std::vector<Term> arguments(atom.arguments().begin(), atom.arguments().end());
  for (Term& argument : arguments) {
    if (!IsComputed(argument)) continue;
    const auto variable = static_cast<logic::Variable>(clause.variable_names.size());
    clause.variable_names.push_back("V" + std::to_string(variable + 1));
    const Term computed = std::exchange(argument, Term::Var(variable));
    clause.literals.push_back({false, logic::Atom(equality, {argument, computed})});
  }
  clause.literals[conclusion].atom = logic::Atom(atom.predicate(), std::move(arguments));
}

}  // namespace

bool IsComputed(const Term& term) {
  return !term.is_variable() && !term.is_number() && !term.arguments().empty() &&
         term.symbol().name().starts_with('$');
}

std::vector<Clause> WithComputedConclusions(std::span<const Clause> clauses,
                                            logic::SymbolTable& symbols) {
  const logic::Symbol equality = symbols.Intern("=");
  std::vector<Clause> flat(clauses.begin(), clauses.end());
  for (Clause& clause : flat) {
    const std::size_t literals = clause.literals.size();
    for (std::size_t i = 0; i < literals; ++i) {
      const Literal& literal = clause.literals[i];
      const bool computes = std::ranges::any_of(literal.atom.arguments(), IsComputed);
      if (computes && literal.positive && IsUninterpreted(literal)) Flatten(clause, i, equality);
    }
  }
  return flat;
}

}  // namespace latchwork::pttp
