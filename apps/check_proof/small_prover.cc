// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/small_prover.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "apps/check_proof/normal_form.h"

namespace latchwork::check_proof {
namespace {

using logic::Atom;
using logic::Literal;
using logic::Term;
using logic::Variable;
using Literals = std::vector<Literal>;
using Bindings = std::map<Variable, Term>;

constexpr std::size_t kMostClauses = 4'000;
constexpr std::size_t kMostUnifications = 3'000'000;
constexpr std::size_t kLargestClause = 600;
constexpr std::size_t kDeepestTerm = 400;

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

Term Resolve(Term term, const Bindings& bindings) {
  while (term.is_variable()) {
    const auto found = bindings.find(term.variable());
    if (found == bindings.end()) break;
    term = found->second;
  }
  return term;
}

Term Apply(const Term& term, const Bindings& bindings) {
  const Term head = Resolve(term, bindings);
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

bool Occurs(Variable variable, const Term& term, const Bindings& bindings) {
  const Term head = Resolve(term, bindings);
  if (head.is_variable()) return head.variable() == variable;
  if (head.is_ground()) return false;
  const auto arguments = head.arguments();
  return std::any_of(arguments.begin(), arguments.end(),
                     [&](const Term& argument) { return Occurs(variable, argument, bindings); });
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

bool Contains(const Term& term, const Term& part) {
  const auto arguments = term.arguments();
  return term == part || std::any_of(arguments.begin(), arguments.end(), [&](const Term& argument) {
           return Contains(argument, part);
         });
}

/// A term with one subterm replaced, for every subterm that is no variable and unifies with
/// `from`; `to` takes its place.
class Rewriter {
 public:
  Rewriter(const Term& from, const Term& to) : from_(from), to_(to) {}

  std::vector<std::pair<Atom, Bindings>> Results(const Atom& atom) {
    std::vector<std::pair<Atom, Bindings>> results;
    for (std::size_t i = 0; i < atom.arity(); ++i) {
      for (auto& [term, bindings] : In(atom.argument(i))) {
        std::vector<Term> arguments(atom.arguments().begin(), atom.arguments().end());
        arguments[i] = std::move(term);
        results.emplace_back(Atom(atom.predicate(), arguments), std::move(bindings));
      }
    }
    return results;
  }

 private:
  std::vector<std::pair<Term, Bindings>> In(const Term& term) {
    std::vector<std::pair<Term, Bindings>> results;
    if (term.is_variable()) return results;
    Bindings bindings;
    if (Unify(from_, term, bindings)) results.emplace_back(to_, std::move(bindings));
    const auto arguments = term.arguments();
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      for (auto& [rewritten, inner] : In(arguments[i])) {
        std::vector<Term> changed(arguments.begin(), arguments.end());
        changed[i] = std::move(rewritten);
        results.emplace_back(Term::Compound(term.symbol(), std::move(changed)), std::move(inner));
      }
    }
    return results;
  }

  const Term& from_;
  const Term& to_;
};

class Saturation {
 public:
  Verdict Run(const std::vector<Literals>& clauses) {
    for (const Literals& clause : clauses) Keep(clause);
    while (!waiting_.empty()) {
      if (refuted_) return Verdict::kYes;
      if (spent_) return Verdict::kTooHard;
      const auto next = waiting_.begin();
      given_ = next->second;
      waiting_.erase(next);
      Activate();
    }
    return refuted_ ? Verdict::kYes : spent_ ? Verdict::kTooHard : Verdict::kNo;
  }

 private:
  /// With sizes, so that the smallest clause is taken next.
  using Queue = std::set<std::pair<std::size_t, Literals>>;

  /// Keeps a clause with its variables numbered anew, unless it is known or a tautology.
  void Keep(Literals clause) {
    std::size_t size = 0;
    for (const Literal& literal : clause) {
      for (const Term& argument : literal.atom.arguments()) {
        std::size_t depth = 0;
        size += Size(argument, depth);
        if (depth > kDeepestTerm) spent_ = true;
      }
    }
    if (size > kLargestClause || ++kept_ > kMostClauses) spent_ = true;
    if (spent_) return;
    std::erase_if(clause, [](const Literal& each) {
      return !each.positive && IsEquation(each) && each.atom.argument(0) == each.atom.argument(1);
    });
    clause = Renumber(std::move(clause));
    if (clause.empty()) refuted_ = true;
    if (IsTautology(clause) || !known_.insert(clause).second) return;
    waiting_.insert({size + 3 * clause.size(), std::move(clause)});
  }

  static Literals Renumber(Literals clause) {
    std::sort(clause.begin(), clause.end());
    Bindings numbers;
    for (Literal& literal : clause) {
      for (const Term& argument : literal.atom.arguments()) Number(argument, numbers);
      literal.atom = Substitute(literal.atom, numbers);
    }
    std::sort(clause.begin(), clause.end());
    clause.erase(std::unique(clause.begin(), clause.end()), clause.end());
    return clause;
  }

  static void Number(const Term& term, Bindings& numbers) {
    if (term.is_variable()) {
      numbers.emplace(term.variable(), Term::Var(static_cast<Variable>(numbers.size())));
    }
    if (term.is_ground()) return;
    for (const Term& argument : term.arguments()) Number(argument, numbers);
  }

  static bool IsTautology(const Literals& clause) {
    return std::any_of(clause.begin(), clause.end(), [&](const Literal& each) {
      if (!each.positive) return false;
      if (IsEquation(each) && each.atom.argument(0) == each.atom.argument(1)) return true;
      return std::binary_search(clause.begin(), clause.end(), Literal{false, each.atom});
    });
  }

  void Activate() {
    active_.push_back(given_);
    Factor();
    const Literals shifted = Shift(given_);
    // By index: nothing is added to `active_` meanwhile.
    for (std::size_t i = 0; i < active_.size() && !spent_ && !refuted_; ++i) {
      const Literals& other = active_[i];
      ResolveWith(shifted, other);
      Paramodulate(shifted, other);
      if (i + 1 < active_.size()) Paramodulate(other, shifted);
    }
  }

  static Literals Shift(const Literals& clause) {
    Bindings numbers;
    for (const Literal& literal : clause) {
      for (const Term& argument : literal.atom.arguments()) Number(argument, numbers);
    }
    const auto count = static_cast<Variable>(numbers.size());
    for (auto& [variable, term] : numbers) term = Term::Var(variable + count + kApart);
    Literals shifted;
    for (const Literal& literal : clause) {
      shifted.push_back({literal.positive, Substitute(literal.atom, numbers)});
    }
    return shifted;
  }

  static void AppendRest(const Literals& clause, std::size_t without, const Bindings& bindings,
                         Literals& result) {
    for (std::size_t i = 0; i < clause.size(); ++i) {
      if (i == without) continue;
      result.push_back({clause[i].positive, Apply(clause[i].atom, bindings)});
    }
  }

  bool Spend() {
    if (++unifications_ > kMostUnifications) spent_ = true;
    return !spent_ && !refuted_;
  }

  void Factor() {
    for (std::size_t i = 0; i < given_.size(); ++i) {
      for (std::size_t j = i + 1; j < given_.size() && Spend(); ++j) {
        Bindings bindings;
        if (given_[i].positive != given_[j].positive ||
            !Unify(given_[i].atom, given_[j].atom, bindings)) {
          continue;
        }
        Literals factor;
        AppendRest(given_, i, bindings, factor);
        Keep(std::move(factor));
      }
      Bindings bindings;
      if (given_[i].positive || !IsEquation(given_[i]) ||
          !Unify(given_[i].atom.argument(0), given_[i].atom.argument(1), bindings)) {
        continue;
      }
      Literals rest;
      AppendRest(given_, i, bindings, rest);
      Keep(std::move(rest));
    }
  }

  void ResolveWith(const Literals& a, const Literals& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size() && Spend(); ++j) {
        Bindings bindings;
        if (a[i].positive == b[j].positive || !Unify(a[i].atom, b[j].atom, bindings)) continue;
        Literals resolvent;
        AppendRest(a, i, bindings, resolvent);
        AppendRest(b, j, bindings, resolvent);
        Keep(std::move(resolvent));
      }
    }
  }

  /// From the equations of `a` into `b`. A side within the other is the smaller one in every
  /// simplification ordering, so nothing needs to be rewritten with it.
  void Paramodulate(const Literals& a, const Literals& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (!a[i].positive || !IsEquation(a[i])) continue;
      for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        if (Contains(a[i].atom.argument(1 - side), a[i].atom.argument(side))) continue;
        Rewriter rewriter(a[i].atom.argument(side), a[i].atom.argument(1 - side));
        for (std::size_t j = 0; j < b.size() && Spend(); ++j) {
          for (const auto& [atom, bindings] : rewriter.Results(b[j].atom)) {
            Literals paramodulant{{b[j].positive, Apply(atom, bindings)}};
            AppendRest(a, i, bindings, paramodulant);
            AppendRest(b, j, bindings, paramodulant);
            Keep(std::move(paramodulant));
          }
        }
      }
    }
  }

  /// Numbers of variables that no clause reaches.
  static constexpr Variable kApart = 1U << 20U;

  std::vector<Literals> active_;
  Queue waiting_;
  std::set<Literals> known_;
  Literals given_;
  std::size_t kept_ = 0;
  std::size_t unifications_ = 0;
  bool refuted_ = false;
  bool spent_ = false;
};

}  // namespace

Verdict Refute(const std::vector<Literals>& clauses) { return Saturation().Run(clauses); }

}  // namespace latchwork::check_proof
