// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/small_terms.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace latchwork::check_proof {
namespace {

using logic::Atom;
using logic::Literal;
using logic::Term;
using logic::Variable;

Term Resolve(Term term, const Bindings& bindings) {
  while (term.is_variable()) {
    const auto found = bindings.find(term.variable());
    if (found == bindings.end()) break;
    term = found->second;
  }
  return term;
}

bool Occurs(Variable variable, const Term& term, const Bindings& bindings) {
  const Term head = Resolve(term, bindings);
  if (head.is_variable()) return head.variable() == variable;
  if (head.is_ground()) return false;
  const auto arguments = head.arguments();
  return std::any_of(arguments.begin(), arguments.end(),
                     [&](const Term& argument) { return Occurs(variable, argument, bindings); });
}

/// What a variable's occurrences and the symbols of two terms differ by.
struct Balance {
  std::map<Variable, int> variables;
  int weight = 0;

  void Add(const Term& term, int sign) {
    weight += sign;
    if (term.is_variable()) variables[term.variable()] += sign;
    for (const Term& argument : term.arguments()) Add(argument, sign);
  }
  bool is_covered() const {
    return std::all_of(variables.begin(), variables.end(),
                       [](const auto& each) { return each.second >= 0; });
  }
};

/// Negative, 0 or positive, as the head of `a` is less than, equal to or greater than that of `b`.
int CompareHeads(const Term& a, const Term& b) {
  if (a.is_number() || b.is_number()) {
    if (a == b) return 0;
    return a < b ? -1 : 1;
  }
  const auto left = std::tuple(a.arguments().size(), a.symbol());
  const auto right = std::tuple(b.arguments().size(), b.symbol());
  if (left == right) return 0;
  return left < right ? -1 : 1;
}

bool IsGreaterLexically(std::span<const Term> a, std::span<const Term> b) {
  const auto [left, right] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return left != a.end() && right != b.end() && IsGreater(*left, *right);
}

}  // namespace

bool IsEquation(const Literal& literal) {
  return literal.atom.predicate().name() == "=" && literal.atom.arity() == 2;
}

std::size_t Size(const Term& term, std::size_t& depth) {
  std::size_t size = 1;
  std::size_t deepest = 0;
  for (const Term& argument : term.arguments()) {
    std::size_t below = 0;
    size += Size(argument, below);
    deepest = std::max(deepest, below);
  }
  depth = deepest + 1;
  return size;
}

Term Apply(const Term& term, const Bindings& bindings) {
  Term head = Resolve(term, bindings);
  if (head.is_variable() || head.is_ground()) return head;
  std::vector<Term> arguments;
  for (const Term& argument : head.arguments()) arguments.push_back(Apply(argument, bindings));
  return Term::Compound(head.symbol(), std::move(arguments));
}

Atom Apply(const Atom& atom, const Bindings& bindings) {
  std::vector<Term> arguments;
  for (const Term& argument : atom.arguments()) arguments.push_back(Apply(argument, bindings));
  return {atom.predicate(), arguments};
}

bool Unify(const Term& left, const Term& right, Bindings& bindings) {
  const Term a = Resolve(left, bindings);
  const Term b = Resolve(right, bindings);
  if (a == b) return true;
  if (a.is_variable() || b.is_variable()) {
    const Term& variable = a.is_variable() ? a : b;
    const Term& value = a.is_variable() ? b : a;
    if (Occurs(variable.variable(), value, bindings)) return false;
    bindings.emplace(variable.variable(), value);
    return true;
  }
  const auto arguments = a.arguments();
  const auto others = b.arguments();
  if (a.kind() != Term::Kind::kCompound || b.kind() != Term::Kind::kCompound ||
      a.symbol() != b.symbol() || arguments.size() != others.size()) {
    return false;
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!Unify(arguments[i], others[i], bindings)) return false;
  }
  return true;
}

bool Unify(const Atom& a, const Atom& b, Bindings& bindings) {
  if (NameOf(a) != NameOf(b)) return false;
  for (std::size_t i = 0; i < a.arity(); ++i) {
    if (!Unify(a.argument(i), b.argument(i), bindings)) return false;
  }
  return true;
}

bool Match(const Term& pattern, const Term& term, Bindings& bindings) {
  if (pattern.is_variable()) {
    return bindings.emplace(pattern.variable(), term).first->second == term;
  }
  if (pattern.kind() != Term::Kind::kCompound) return pattern == term;
  const auto arguments = pattern.arguments();
  const auto others = term.arguments();
  if (term.kind() != Term::Kind::kCompound || pattern.symbol() != term.symbol() ||
      arguments.size() != others.size()) {
    return false;
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!Match(arguments[i], others[i], bindings)) return false;
  }
  return true;
}

bool Match(const Atom& pattern, const Atom& atom, Bindings& bindings) {
  if (NameOf(pattern) != NameOf(atom)) return false;
  for (std::size_t i = 0; i < pattern.arity(); ++i) {
    if (!Match(pattern.argument(i), atom.argument(i), bindings)) return false;
  }
  return true;
}

bool Contains(const Term& term, const Term& part) {
  const auto arguments = term.arguments();
  return term == part || std::any_of(arguments.begin(), arguments.end(), [&](const Term& argument) {
           return Contains(argument, part);
         });
}

bool IsGreater(const Term& a, const Term& b) {
  if (a.is_variable()) return false;
  if (b.is_variable()) return Contains(a, b);
  Balance balance;
  balance.Add(a, 1);
  balance.Add(b, -1);
  if (balance.weight < 0 || !balance.is_covered()) return false;
  if (balance.weight > 0) return true;
  const int heads = CompareHeads(a, b);
  return heads > 0 || (heads == 0 && IsGreaterLexically(a.arguments(), b.arguments()));
}

bool IsGreater(const Atom& a, const Atom& b) {
  Balance balance;
  for (const Term& argument : a.arguments()) balance.Add(argument, 1);
  for (const Term& argument : b.arguments()) balance.Add(argument, -1);
  if (balance.weight < 0 || !balance.is_covered()) return false;
  if (balance.weight > 0) return true;
  const auto left = NameOf(a);
  const auto right = NameOf(b);
  return right < left || (left == right && IsGreaterLexically(a.arguments(), b.arguments()));
}

}  // namespace latchwork::check_proof
