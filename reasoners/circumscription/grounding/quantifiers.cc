// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/grounding/quantifiers.h"

#include <map>
#include <utility>

namespace latchwork::circumscription {
namespace {

using logic::Formula;
using logic::Term;
using Kind = logic::Formula::Kind;

constexpr int kMaxDepth = 1000;

/// Where a formula stands: under an even number of negations, an odd one, or (within an
/// equivalence) both.
enum class Polarity : unsigned char { kPositive, kNegative, kBoth };

Polarity Opposite(Polarity polarity) {
  if (polarity == Polarity::kBoth) return polarity;
  return polarity == Polarity::kPositive ? Polarity::kNegative : Polarity::kPositive;
}

class Expansion {
 public:
  Expansion(const std::vector<Term>& domain, std::size_t max_atoms)
      : domain_(domain), left_(max_atoms) {}

  Formula Expand(const Formula& formula, Polarity polarity, int depth) {
    if (depth > kMaxDepth) failed_ = true;
    if (failed_) return Formula::True();
    switch (formula.kind()) {
      case Kind::kAtom:
        return ExpandAtom(formula.atom());
      case Kind::kForall:
      case Kind::kExists:
        return ExpandQuantifier(formula, polarity, depth);
      case Kind::kTrue:
      case Kind::kFalse:
        return formula;
      default:
        return ExpandConnective(formula, polarity, depth);
    }
  }
  bool failed() const { return failed_; }

 private:
  Formula ExpandAtom(const logic::Atom& atom) {
    if (left_ == 0) {
      failed_ = true;
      return Formula::True();
    }
    --left_;
    std::vector<Term> arguments;
    for (const Term& argument : atom.arguments()) {
      const auto place = argument.is_variable() ? values_.find(argument.variable()) : values_.end();
      arguments.push_back(place == values_.end() ? argument : place->second);
    }
    return Formula::Of(logic::Atom(atom.predicate(), arguments));
  }

  Formula ExpandConnective(const Formula& formula, Polarity polarity, int depth) {
    const auto children = formula.children();
    std::vector<Formula> expanded;
    for (std::size_t i = 0; i < children.size(); ++i) {
      Polarity own = polarity;
      if (formula.kind() == Kind::kEquivalent) own = Polarity::kBoth;
      const bool premise = formula.kind() == Kind::kImplies && i == 0;
      if (formula.kind() == Kind::kNot || premise) own = Opposite(polarity);
      expanded.push_back(Expand(children[i], own, depth + 1));
    }
    return formula.With(std::move(expanded));
  }

  Formula ExpandQuantifier(const Formula& formula, Polarity polarity, int depth) {
    const bool exists = formula.kind() == Kind::kExists;
    const Polarity kept = exists ? Polarity::kNegative : Polarity::kPositive;
    const auto& bound = formula.variables();
    const std::vector<logic::Variable> variables(bound.begin(), bound.end());
    if (polarity != kept) return ExpandVariables(formula, variables, 0, polarity, depth);
    Formula child = Expand(formula.children()[0], polarity, depth + 1);
    return exists ? Formula::Exists(variables, std::move(child))
                  : Formula::Forall(variables, std::move(child));
  }

  Formula ExpandVariables(const Formula& quantified, const std::vector<logic::Variable>& variables,
                          std::size_t next, Polarity polarity, int depth) {
    if (next == variables.size()) return Expand(quantified.children()[0], polarity, depth + 1);
    std::vector<Formula> instances;
    for (const Term& value : domain_) {
      if (failed_) break;
      values_[variables[next]] = value;
      instances.push_back(ExpandVariables(quantified, variables, next + 1, polarity, depth + 1));
    }
    values_.erase(variables[next]);
    if (failed_) return Formula::True();
    if (instances.size() == 1) return instances[0];
    return quantified.kind() == Kind::kExists ? Formula::Or(std::move(instances))
                                              : Formula::And(std::move(instances));
  }

  const std::vector<Term>& domain_;
  std::size_t left_;
  bool failed_ = false;
  std::map<logic::Variable, Term> values_;
};

}  // namespace

std::optional<Formula> ExpandExistentials(const Formula& formula, const std::vector<Term>& domain,
                                          std::size_t max_atoms) {
  Expansion expansion(domain, max_atoms);
  Formula expanded = expansion.Expand(formula, Polarity::kPositive, 0);
  if (expansion.failed()) return std::nullopt;
  return expanded;
}

}  // namespace latchwork::circumscription
