// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/grounding/tptp_problem.h"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <utility>

#include "latchwork/logic/clausify.h"
#include "reasoners/circumscription/grounding/quantifiers.h"

namespace latchwork::circumscription {
namespace {

using logic::AnnotatedFormula;
using logic::Formula;
using logic::Term;

/// Calls `visit` with every atom, from left to right; nesting may be deep.
template <typename Visit>
void ForEachAtom(const Formula& formula, const Visit& visit) {
  std::vector<const Formula*> open = {&formula};
  while (!open.empty()) {
    const Formula& next = *open.back();
    open.pop_back();
    if (next.kind() == Formula::Kind::kAtom) visit(next.atom());
    const auto children = next.children();
    for (auto child = children.rbegin(); child != children.rend(); ++child) open.push_back(&*child);
  }
}

class Problem {
 public:
  Problem(const PredicateRoles& roles, logic::SymbolTable& symbols, const GroundingLimits& limits)
      : roles_(roles), symbols_(symbols), limits_(limits) {}

  TptpProblem Ground(const std::vector<AnnotatedFormula>& formulas) {
    for (const AnnotatedFormula& formula : formulas) CheckFormula(formula);
    if (!result_.diagnostics.empty()) return std::move(result_);
    // Something exists, named or not.
    if (domain_.empty()) domain_.push_back(Term::Constant(symbols_.Fresh("element")));
    for (const AnnotatedFormula& formula : formulas) AddFormula(formula);
    if (!result_.diagnostics.empty()) return std::move(result_);
    const std::vector<logic::Clause> clauses =
        logic::Clausify(expanded_, symbols_, {}, &result_.diagnostics);
    Grounder grounder(roles_, domain_, limits_.steps);
    if (!grounder.Ground(clauses)) {
      Refuse(formulas.front(), fmt::format("grounding takes more than {} steps", limits_.steps));
    }
    result_.theory = grounder.theory();
    for (std::size_t i = 0; i < result_.queries.size(); ++i) AddQueryLiteral(grounder, i);
    return std::move(result_);
  }

 private:
  void Refuse(const AnnotatedFormula& formula, std::string message, std::string hint = "") {
    logic::SourcePlace place = formula.place;
    result_.diagnostics.push_back({std::move(place), std::move(message), std::move(hint), ""});
  }

  void CheckFormula(const AnnotatedFormula& formula) {
    std::set<std::string> reasons;
    ForEachAtom(formula.formula, [&](const logic::Atom& atom) {
      if (atom.predicate().name().starts_with("$")) {
        reasons.insert(fmt::format("'{}' is arithmetic", ToString(NameOf(atom))));
      }
      for (const Term& argument : atom.arguments()) CheckTerm(argument, reasons);
    });
    for (const std::string& reason : reasons) {
      Refuse(formula, fmt::format("'{}' cannot be grounded: {}", formula.name, reason),
             "exact circumscription needs a finite domain: constants and variables only");
    }
  }

  void CheckTerm(const Term& term, std::set<std::string>& reasons) {
    if (term.kind() == Term::Kind::kCompound) {
      reasons.insert(
          fmt::format("'{}/{}' is a function", term.symbol().name(), term.arguments().size()));
    } else if (!term.is_variable() && known_.insert(term).second) {
      domain_.push_back(term);
    }
  }

  void AddFormula(const AnnotatedFormula& formula) {
    AnnotatedFormula axiom = formula;
    axiom.role = logic::Role::kAxiom;
    if (formula.role == logic::Role::kConjecture) {
      const logic::Atom query(symbols_.Fresh("query"));
      asked_.push_back(query);
      result_.queries.push_back({formula.name, false, {}});
      axiom.formula = Formula::Equivalent(Formula::Of(query), formula.formula);
    }
    std::optional<Formula> expanded =
        ExpandExistentials(axiom.formula, domain_, limits_.atoms_of_formula);
    if (!expanded) {
      Refuse(formula,
             fmt::format("'{}' is too large once its quantifiers are written out over {} constants",
                         formula.name, domain_.size()));
      return;
    }
    axiom.formula = *std::move(expanded);
    expanded_.push_back(std::move(axiom));
  }

  /// A query that no instance mentions is decided: its formula is valid or contradictory.
  void AddQueryLiteral(const Grounder& grounder, std::size_t index) {
    const std::optional<Atom> atom = grounder.Find(asked_[index]);
    result_.queries[index].literals = {atom ? *atom : result_.theory.Add({})};
  }

  const PredicateRoles& roles_;
  logic::SymbolTable& symbols_;
  GroundingLimits limits_;
  std::set<Term> known_;
  std::vector<Term> domain_;
  std::vector<logic::Atom> asked_;  ///< Per query, what its conjecture is equivalent to.
  std::vector<AnnotatedFormula> expanded_;
  TptpProblem result_;
};

}  // namespace

TptpProblem GroundTptp(const std::vector<AnnotatedFormula>& formulas, const PredicateRoles& roles,
                       logic::SymbolTable& symbols, const GroundingLimits& limits) {
  return Problem(roles, symbols, limits).Ground(formulas);
}

std::vector<logic::PredicateName> PredicatesOf(const std::vector<AnnotatedFormula>& formulas) {
  std::set<logic::PredicateName> names;
  for (const AnnotatedFormula& formula : formulas) {
    ForEachAtom(formula.formula, [&](const logic::Atom& atom) { names.insert(NameOf(atom)); });
  }
  std::vector<logic::PredicateName> predicates;
  for (const logic::PredicateName& name : names) {
    if (name.symbol.name() != "=") predicates.push_back(name);
  }
  return predicates;
}

}  // namespace latchwork::circumscription
