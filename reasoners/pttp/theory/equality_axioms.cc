// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/theory/equality_axioms.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

namespace latchwork::pttp {
namespace {

using logic::Atom;
using logic::Clause;
using logic::PredicateName;
using logic::Term;

/// The functions and predicates of clauses, ordered by name. Interpreted ones need no axioms.
class Signature {
 public:
  explicit Signature(logic::Symbol equality) : equality_(equality) {}

  void Add(const Atom& atom) {
    if (atom.arity() > 0 && atom.predicate() != equality_ && !IsInterpreted(atom.predicate())) {
      predicates.insert(NameOf(atom));
    }
    std::vector<const Term*> visits;
    for (const Term& term : atom.arguments()) visits.push_back(&term);
    while (!visits.empty()) {
      const Term& term = *visits.back();
      visits.pop_back();
      if (term.kind() != Term::Kind::kCompound) continue;
      if (!IsInterpreted(term.symbol())) functions.insert({term.symbol(), term.arguments().size()});
      for (const Term& argument : term.arguments()) visits.push_back(&argument);
    }
  }

  std::set<PredicateName> predicates;
  std::set<PredicateName> functions;

 private:
  static bool IsInterpreted(logic::Symbol symbol) { return symbol.name().starts_with('$'); }

  logic::Symbol equality_;
};

class AxiomMaker {
 public:
  explicit AxiomMaker(logic::Symbol equality) : equality_(equality) {}

  Clause Reflexivity() const { return Make("reflexivity", {Equal(true, 0, 0)}, 1); }
  Clause Symmetry() const { return Make("symmetry", {Equal(false, 0, 1), Equal(true, 1, 0)}, 2); }
  Clause Transitivity() const {
    return Make("transitivity", {Equal(false, 0, 1), Equal(false, 1, 2), Equal(true, 0, 2)}, 3);
  }
  Clause Substitution(const PredicateName& name, bool is_function) const {
    std::vector<logic::Literal> literals;
    std::vector<Term> before;
    std::vector<Term> after;
    for (logic::Variable i = 0; i < name.arity; ++i) {
      literals.push_back(Equal(false, 2 * i, 2 * i + 1));
      before.push_back(Term::Var(2 * i));
      after.push_back(Term::Var(2 * i + 1));
    }
    if (is_function) {
      literals.push_back({true, Atom(equality_, {Term::Compound(name.symbol, before),
                                                 Term::Compound(name.symbol, after)})});
    } else {
      literals.push_back({false, Atom(name.symbol, before)});
      literals.push_back({true, Atom(name.symbol, after)});
    }
    return Make(fmt::format("substitution_{}", name.symbol.name()), std::move(literals),
                2 * name.arity);
  }

 private:
  logic::Literal Equal(bool positive, logic::Variable a, logic::Variable b) const {
    return {positive, Atom(equality_, {Term::Var(a), Term::Var(b)})};
  }
  static Clause Make(std::string name, std::vector<logic::Literal> literals,
                     std::size_t variables) {
    Clause clause;
    clause.name = std::move(name);
    clause.literals = std::move(literals);
    for (std::size_t i = 0; i < variables; ++i) {
      clause.variable_names.push_back(fmt::format("X{}", i));
    }
    return clause;
  }

  logic::Symbol equality_;
};

}  // namespace

Clause Reflexivity(logic::SymbolTable& symbols) {
  return AxiomMaker(symbols.Intern("=")).Reflexivity();
}

std::vector<Clause> EqualityAxioms(std::span<const Clause> clauses,
                                   std::span<const logic::Fact> facts,
                                   logic::SymbolTable& symbols) {
  const logic::Symbol equality = symbols.Intern("=");
  const auto concludes_equation = [&](const Clause& clause) {
    return std::any_of(clause.literals.begin(), clause.literals.end(), [&](const auto& literal) {
      return literal.positive && literal.atom.predicate() == equality;
    });
  };
  if (std::none_of(clauses.begin(), clauses.end(), concludes_equation)) return {};
  Signature signature(equality);
  for (const Clause& clause : clauses) {
    for (const logic::Literal& literal : clause.literals) signature.Add(literal.atom);
  }
  for (const logic::Fact& fact : facts) signature.Add(fact);
  const AxiomMaker maker(equality);
  std::vector<Clause> axioms{maker.Symmetry(), maker.Transitivity()};
  for (const auto& name : signature.functions) axioms.push_back(maker.Substitution(name, true));
  for (const auto& name : signature.predicates) axioms.push_back(maker.Substitution(name, false));
  return axioms;
}

}  // namespace latchwork::pttp
