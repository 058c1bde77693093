// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/small_prover.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>

#include "apps/check_proof/normal_form.h"
#include "apps/check_proof/small_simplifier.h"
#include "apps/check_proof/small_terms.h"

namespace latchwork::check_proof {
namespace {

using logic::Atom;
using logic::Literal;
using logic::Term;
using logic::Variable;
using Literals = std::vector<Literal>;

constexpr std::size_t kMostClauses = 4'000;
constexpr std::size_t kMostUnifications = 3'000'000;
constexpr std::size_t kLargestClause = 600;
constexpr std::size_t kDeepestTerm = 400;

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

/// Forward from positive clauses, or with every literal of every clause.
enum class Manner : std::uint8_t { kForward, kAnyLiteral };

/// The literals that take part in inferences: all, or of a clause with negative ones the largest of
/// these, else those that no other exceeds.
std::vector<std::size_t> Eligible(const Literals& clause, Manner manner) {
  std::vector<std::size_t> eligible;
  if (manner == Manner::kAnyLiteral) {
    eligible.resize(clause.size());
    std::iota(eligible.begin(), eligible.end(), std::size_t{0});
    return eligible;
  }
  std::size_t largest = 0;
  for (std::size_t i = 0; i < clause.size(); ++i) {
    if (clause[i].positive) continue;
    std::size_t size = 1;
    std::size_t depth = 0;
    for (const Term& argument : clause[i].atom.arguments()) size += Size(argument, depth);
    if (size > largest) eligible.assign(1, i);
    largest = std::max(largest, size);
  }
  if (!eligible.empty()) return eligible;
  for (std::size_t i = 0; i < clause.size(); ++i) {
    const bool exceeded = std::any_of(clause.begin(), clause.end(), [&](const Literal& other) {
      return !IsEquation(other) && !IsEquation(clause[i]) && IsGreater(other.atom, clause[i].atom);
    });
    if (!exceeded) eligible.push_back(i);
  }
  return eligible;
}

bool IsPositive(const Literals& clause) {
  return std::all_of(clause.begin(), clause.end(), [](const auto& each) { return each.positive; });
}

class Saturation {
 public:
  explicit Saturation(Manner manner) : manner_(manner) {}

  Verdict Run(const std::vector<Literals>& clauses) {
    for (const Literals& clause : clauses) Keep(clause);
    reads_ = false;
    while (!waiting_.empty()) {
      if (refuted_) return Verdict::kYes;
      if (spent_) return Verdict::kTooHard;
      const auto next = waiting_.begin();
      given_ = next->second;
      waiting_.erase(next);
      if (IsNew()) Activate();
    }
    return refuted_ ? Verdict::kYes : spent_ ? Verdict::kTooHard : Verdict::kNo;
  }

 private:
  /// With sizes, so that the smallest clause is taken next, but all that are given at first.
  using Queue = std::set<std::pair<std::size_t, Literals>>;

  /// Keeps a clause, simplified and with its variables numbered anew, unless it is known or a
  /// tautology.
  void Keep(Literals clause) {
    simplifier_.Simplify(clause);
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
    clause = Renumber(std::move(clause));
    if (clause.empty()) refuted_ = true;
    if (IsTautology(clause) || !known_.insert(clause).second) return;
    waiting_.insert({reads_ ? clause.size() : size + 3 * clause.size(), std::move(clause)});
  }

  /// Whether the clause at hand says more than the active ones. A simpler one is kept in its stead.
  bool IsNew() {
    Literals simpler = given_;
    if (simplifier_.Simplify(simpler)) {
      Keep(std::move(simpler));
      return false;
    }
    return std::none_of(active_.begin(), active_.end(),
                        [&](const Literals& each) { return Subsumes(each, given_); });
  }

  /// Takes away what the new clause makes superfluous, and simplifies what it can.
  void CleanActive() {
    const bool is_unit = given_.size() == 1;
    if (is_unit) simplifier_.AddUnit(given_[0]);
    std::vector<Literals> simpler;
    std::erase_if(active_, [&](const Literals& each) {
      bool superfluous = Subsumes(given_, each);
      if (!superfluous && is_unit) {
        if (each.size() == 1) simplifier_.RemoveUnit(each[0]);
        Literals changed = each;
        superfluous = simplifier_.Simplify(changed);
        if (superfluous) simpler.push_back(std::move(changed));
        if (each.size() == 1 && !superfluous) simplifier_.AddUnit(each[0]);
      } else if (superfluous && each.size() == 1) {
        simplifier_.RemoveUnit(each[0]);
      }
      return superfluous;
    });
    for (Literals& each : simpler) Keep(std::move(each));
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
      if (SmallSimplifier::IsTrue(each)) return true;
      return each.positive &&
             std::binary_search(clause.begin(), clause.end(), Literal{false, each.atom});
    });
  }

  void Activate() {
    CleanActive();
    active_.push_back(given_);
    Factor();
    ResolveEquality();
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

  /// Whether inferences start from the positive literals of a clause.
  bool IsSource(const Literals& clause) const {
    return manner_ == Manner::kAnyLiteral || IsPositive(clause);
  }

  void Factor() {
    if (!IsSource(given_)) return;
    for (const std::size_t i : Eligible(given_, manner_)) {
      for (std::size_t j = 0; j < given_.size() && Spend(); ++j) {
        if (i == j || given_[i].positive != given_[j].positive) continue;
        Bindings bindings;
        if (Unify(given_[i].atom, given_[j].atom, bindings)) {
          Literals factor;
          AppendRest(given_, i, bindings, factor);
          Keep(std::move(factor));
        }
        const bool equations = IsEquation(given_[i]) && IsEquation(given_[j]);
        if (equations && given_[i].positive) FactorEquations(i, j);
      }
    }
  }

  /// Of s = t and u = v where s and u unify: t != v takes the place of the first.
  void FactorEquations(std::size_t i, std::size_t j) {
    const Atom& first = given_[i].atom;
    const Atom& second = given_[j].atom;
    for (std::size_t side = 0; side < 4; ++side) {
      Bindings bindings;
      if (!Unify(first.argument(side / 2), second.argument(side % 2), bindings)) continue;
      const Atom apart(first.predicate(),
                       {first.argument(1 - side / 2), second.argument(1 - side % 2)});
      Literals factor{{false, Apply(apart, bindings)}};
      AppendRest(given_, i, bindings, factor);
      Keep(std::move(factor));
    }
  }

  void ResolveEquality() {
    for (const std::size_t i : Eligible(given_, manner_)) {
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
    if (!IsSource(a) && !IsSource(b)) return;
    for (const std::size_t i : Eligible(a, manner_)) {
      for (const std::size_t j : Eligible(b, manner_)) {
        Bindings bindings;
        if (a[i].positive == b[j].positive || !Spend() || !Unify(a[i].atom, b[j].atom, bindings)) {
          continue;
        }
        Literals resolvent;
        AppendRest(a, i, bindings, resolvent);
        AppendRest(b, j, bindings, resolvent);
        Keep(std::move(resolvent));
      }
    }
  }

  /// From the equations of `a` into `b`, from sides that are not the smaller ones.
  void Paramodulate(const Literals& a, const Literals& b) {
    if (!IsSource(a)) return;
    for (const std::size_t i : Eligible(a, manner_)) {
      if (!a[i].positive || !IsEquation(a[i])) continue;
      for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        if (IsGreater(a[i].atom.argument(1 - side), a[i].atom.argument(side))) continue;
        ParamodulateFrom(a, i, side, b);
      }
    }
  }

  void ParamodulateFrom(const Literals& a, std::size_t i, std::size_t side, const Literals& b) {
    const Term& from = a[i].atom.argument(side);
    const Term& to = a[i].atom.argument(1 - side);
    Rewriter rewriter(from, to);
    for (const std::size_t j : Eligible(b, manner_)) {
      if (!Spend()) return;
      for (const auto& [atom, bindings] : rewriter.Results(b[j].atom)) {
        if (IsGreater(Apply(to, bindings), Apply(from, bindings))) continue;
        Literals paramodulant{{b[j].positive, Apply(atom, bindings)}};
        AppendRest(a, i, bindings, paramodulant);
        AppendRest(b, j, bindings, paramodulant);
        Keep(std::move(paramodulant));
      }
    }
  }

  /// Numbers of variables that no clause reaches.
  static constexpr Variable kApart = 1U << 20U;

  Manner manner_;
  SmallSimplifier simplifier_;
  std::vector<Literals> active_;
  Queue waiting_;
  std::set<Literals> known_;
  Literals given_;
  std::size_t kept_ = 0;
  std::size_t unifications_ = 0;
  bool reads_ = true;
  bool refuted_ = false;
  bool spent_ = false;
};

}  // namespace

Verdict Refute(const std::vector<Literals>& clauses) {
  const Verdict verdict = Saturation(Manner::kForward).Run(clauses);
  return verdict == Verdict::kTooHard ? Saturation(Manner::kAnyLiteral).Run(clauses) : verdict;
}

}  // namespace latchwork::check_proof
