// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/entailment.h"

#include <map>
#include <string>
#include <utility>

#include "apps/check_proof/normal_form.h"
#include "apps/check_proof/propositional.h"
#include "apps/check_proof/small_prover.h"

namespace latchwork::check_proof {
namespace {

using logic::AnnotatedFormula;
using logic::Formula;
using logic::Literal;
using logic::Term;
using logic::Variable;
using Kind = Tree::Kind;
using Literals = std::vector<Literal>;

constexpr std::size_t kMostClauses = 5'000;
/// More of them are not multiplied out: subformulas get names.
constexpr std::size_t kMostProducts = 64;

/// Clauses by Skolemization and distribution.
class Clauses {
 public:
  explicit Clauses(logic::SymbolTable& symbols) : symbols_(symbols) {}

  /// False when there are too many.
  bool Add(const Formula& formula, bool positive, std::vector<Literals>& clauses) {
    const auto tree = Normalizer(none_).Normalize(formula, positive);
    if (!tree) return false;
    scope_.clear();
    values_.clear();
    return Expand(*tree, clauses);
  }

 private:
  bool Expand(const Tree& tree, std::vector<Literals>& clauses) {
    switch (tree.kind) {
      case Kind::kTrue:
        return true;
      case Kind::kFalse:
        clauses.emplace_back();
        return true;
      case Kind::kLiteral:
        clauses.push_back({{tree.literal.positive, Substitute(tree.literal.atom, values_)}});
        return true;
      case Kind::kAnd:
        for (const Tree& child : tree.children) {
          if (!Expand(child, clauses)) return false;
        }
        return clauses.size() <= kMostClauses;
      case Kind::kOr:
        return Distribute(tree, clauses);
      case Kind::kForall:
      case Kind::kExists:
        break;
    }
    return ExpandQuantifier(tree, clauses);
  }

  bool ExpandQuantifier(const Tree& tree, std::vector<Literals>& clauses) {
    const std::size_t outer = scope_.size();
    for (const Variable variable : tree.variables) {
      if (tree.kind == Kind::kForall) {
        scope_.push_back(Term::Var(variable));
      } else {
        const logic::Symbol symbol = symbols_.Fresh("checked_");
        values_.insert_or_assign(
            variable, scope_.empty() ? Term::Constant(symbol) : Term::Compound(symbol, scope_));
      }
    }
    const bool done = Expand(tree.children[0], clauses);
    scope_.resize(outer);
    return done;
  }

  bool Distribute(const Tree& tree, std::vector<Literals>& clauses) {
    std::vector<Literals> product(1);
    for (const Tree& child : tree.children) {
      std::vector<Literals> of_child;
      if (!Expand(child, of_child)) return false;
      if (of_child.size() > 1 && product.size() * of_child.size() > kMostProducts) {
        of_child = {{Name(of_child, clauses)}};
      }
      std::vector<Literals> next;
      for (const Literals& left : product) {
        for (const Literals& right : of_child) {
          next.push_back(left);
          next.back().insert(next.back().end(), right.begin(), right.end());
        }
      }
      product = std::move(next);
    }
    clauses.insert(clauses.end(), product.begin(), product.end());
    return clauses.size() <= kMostClauses;
  }

  /// An atom that implies the clauses; that it does is added. What follows from both and has not
  /// its name in it follows from the clauses.
  Literal Name(const std::vector<Literals>& named, std::vector<Literals>& clauses) {
    const logic::Atom name(symbols_.Fresh("checked_"), scope_);
    for (const Literals& each : named) {
      clauses.push_back(each);
      clauses.back().push_back({false, name});
    }
    return {true, name};
  }

  const Definitions none_;
  logic::SymbolTable& symbols_;
  std::vector<Term> scope_;
  std::map<Variable, Term> values_;
};

/// Reads clauses such that variables of the same name are one.
class SharedVariables {
 public:
  /// False where the formula is no clause, or too deep.
  bool Read(const AnnotatedFormula& formula, Literals& clause) {
    if (!ToLiterals(formula.formula, clause)) return false;
    std::map<Variable, Term> values;
    for (std::size_t i = 0; i < formula.variable_names.size(); ++i) {
      const auto next = static_cast<Variable>(numbers_.size());
      const auto place = numbers_.emplace(formula.variable_names[i], next).first;
      values.emplace(static_cast<Variable>(i), Term::Var(place->second));
    }
    for (Literal& literal : clause) {
      if (!IsShallow(literal.atom)) return false;
      literal.atom = Substitute(literal.atom, values);
    }
    return true;
  }

 private:
  std::map<std::string, Variable> numbers_;
};

}  // namespace

Verdict Entails(const std::vector<const AnnotatedFormula*>& premises, const Formula& conclusion,
                logic::SymbolTable& symbols) {
  Clauses maker(symbols);
  std::vector<Literals> clauses;
  for (const AnnotatedFormula* premise : premises) {
    if (!maker.Add(premise->formula, true, clauses)) return Verdict::kTooHard;
  }
  if (!maker.Add(conclusion, false, clauses)) return Verdict::kTooHard;
  return Refute(clauses);
}

bool ToLiterals(const Formula& formula, std::vector<Literal>& literals) {
  std::vector<Formula> pending{formula};
  while (pending.size() == 1 && pending[0].kind() == Formula::Kind::kForall) {
    pending[0] = Formula(pending[0].children()[0]);
  }
  while (!pending.empty()) {
    const Formula next = std::move(pending.back());
    pending.pop_back();
    const auto children = next.children();
    switch (next.kind()) {
      case Formula::Kind::kOr:
        pending.insert(pending.end(), children.rbegin(), children.rend());
        break;
      case Formula::Kind::kAtom:
        literals.push_back({true, next.atom()});
        break;
      case Formula::Kind::kNot:
        if (children[0].kind() != Formula::Kind::kAtom) return false;
        literals.push_back({false, children[0].atom()});
        break;
      case Formula::Kind::kFalse:
        break;
      default:
        return false;
    }
  }
  return true;
}

Verdict EntailsAsClauses(const std::vector<const AnnotatedFormula*>& premises,
                         const AnnotatedFormula& conclusion) {
  SharedVariables shared;
  std::vector<Literals> clauses(premises.size());
  for (std::size_t i = 0; i < premises.size(); ++i) {
    if (!shared.Read(*premises[i], clauses[i])) return Verdict::kTooHard;
  }
  Literals concluded;
  if (!shared.Read(conclusion, concluded)) return Verdict::kTooHard;
  for (const Literal& literal : concluded) clauses.push_back({{!literal.positive, literal.atom}});
  return Contradict(clauses);
}

}  // namespace latchwork::check_proof
