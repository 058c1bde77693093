// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/strategies/prover_problem.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "latchwork/logic/clausify.h"
#include "reasoners/pttp/terms/exact_reals.h"
#include "reasoners/pttp/theory/equality_axioms.h"

namespace latchwork::pttp {
namespace {

using logic::Clause;
using logic::Term;

struct Meaning {
  bool equality = false;
  bool arithmetic = false;
  bool distinct = false;
  bool reals = false;
  bool rounded_numeral = false;
};

void LookAtNumber(const Term& number, Meaning& meaning) {
  if (number.kind() != Term::Kind::kReal) return;
  meaning.reals = true;
  meaning.rounded_numeral = meaning.rounded_numeral || !IsExactNumeral(number.real());
}

void Look(const Term& term, Meaning& meaning) {
  std::vector<const Term*> visits{&term};
  while (!visits.empty()) {
    const Term& current = *visits.back();
    visits.pop_back();
    if (current.is_variable()) continue;
    if (current.is_number()) {
      meaning.arithmetic = true;
      LookAtNumber(current, meaning);
      continue;
    }
    const logic::Symbol symbol = current.symbol();
    meaning.distinct = meaning.distinct || symbol.kind() == logic::SymbolKind::kDistinctObject;
    meaning.arithmetic = meaning.arithmetic || symbol.name().starts_with('$');
    meaning.reals = meaning.reals || symbol.name() == "$quotient" || symbol.name() == "$to_real";
    for (const Term& argument : current.arguments()) visits.push_back(&argument);
  }
}

void Look(const Clause& clause, Meaning& meaning) {
  for (const logic::Literal& literal : clause.literals) {
    const std::string_view predicate = literal.atom.predicate().name();
    meaning.arithmetic = meaning.arithmetic || predicate.starts_with('$');
    meaning.equality = meaning.equality || predicate == "=";
    for (const Term& argument : literal.atom.arguments()) Look(argument, meaning);
  }
}

}  // namespace

ProverProblem::ProverProblem(const std::vector<logic::AnnotatedFormula>& formulas,
                             logic::SymbolTable& symbols, bool with_origins) {
  clauses = logic::Clausify(formulas, symbols, {}, nullptr, with_origins ? &origins : nullptr);
  input_size = clauses.size();
  has_conjecture = std::any_of(formulas.begin(), formulas.end(), [](const auto& formula) {
    return formula.role == logic::Role::kConjecture;
  });
  Meaning meaning;
  for (const Clause& clause : clauses) Look(clause, meaning);
  has_arithmetic = meaning.arithmetic;
  if (meaning.reals) reals = meaning.rounded_numeral ? Reals::kGiven : Reals::kExact;
  has_fixed_meaning = meaning.arithmetic || meaning.distinct;
  std::vector<Clause> axioms = EqualityAxioms(clauses, {}, symbols);
  has_equality = !axioms.empty();
  for (Clause& axiom : axioms) clauses.push_back(std::move(axiom));
  engine_size = clauses.size();
  if (meaning.equality) clauses.push_back(Reflexivity(symbols));
}

}  // namespace latchwork::pttp
