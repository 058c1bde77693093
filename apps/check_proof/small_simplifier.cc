// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/small_simplifier.h"

#include <algorithm>
#include <utility>

#include "apps/check_proof/normal_form.h"
#include "apps/check_proof/small_terms.h"

namespace latchwork::check_proof {
namespace {

using logic::Atom;
using logic::Literal;
using logic::Term;
using Literals = std::vector<Literal>;

constexpr std::size_t kMostRewrites = 2'000;
constexpr std::size_t kMostMatches = 5'000;

/// Both ways of reading an equation; of other atoms the only one.
std::vector<Atom> Readings(const Literal& literal) {
  std::vector<Atom> readings{literal.atom};
  if (IsEquation(literal)) {
    const Atom& atom = literal.atom;
    readings.emplace_back(atom.predicate(),
                          std::initializer_list<Term>{atom.argument(1), atom.argument(0)});
  }
  return readings;
}

/// Terms that are unequal whatever they stand for: numbers, and distinct objects.
bool AreDistinct(const Term& a, const Term& b) {
  const auto is_object = [](const Term& term) {
    return term.kind() == Term::Kind::kConstant &&
           term.symbol().kind() == logic::SymbolKind::kDistinctObject;
  };
  const bool fixed = (a.is_number() || is_object(a)) && (b.is_number() || is_object(b));
  return fixed && a != b && (a.kind() == b.kind() || is_object(a) || is_object(b));
}

class Subsumption {
 public:
  Subsumption(const Literals& general, const Literals& special)
      : general_(general), special_(special) {}

  bool From(std::size_t index, const Bindings& bindings) {
    if (index == general_.size()) return true;
    for (const Literal& literal : special_) {
      if (literal.positive != general_[index].positive) continue;
      for (const Atom& reading : Readings(general_[index])) {
        if (++matches_ > kMostMatches) return false;
        Bindings extended = bindings;
        if (Match(reading, literal.atom, extended) && From(index + 1, extended)) return true;
      }
    }
    return false;
  }

 private:
  const Literals& general_;
  const Literals& special_;
  std::size_t matches_ = 0;
};

}  // namespace

void SmallSimplifier::AddUnit(const Literal& unit) {
  (unit.positive && IsEquation(unit) ? equations_ : units_).push_back(unit);
}

void SmallSimplifier::RemoveUnit(const Literal& unit) {
  std::erase(units_, unit);
  std::erase(equations_, unit);
}

bool SmallSimplifier::IsFalse(const Literal& literal) {
  if (!IsEquation(literal)) return false;
  const Term& left = literal.atom.argument(0);
  const Term& right = literal.atom.argument(1);
  return literal.positive ? AreDistinct(left, right) : left == right;
}

bool SmallSimplifier::IsTrue(const Literal& literal) {
  return IsFalse({!literal.positive, literal.atom});
}

bool SmallSimplifier::Simplify(Literals& clause) const {
  std::size_t steps = 0;
  for (Literal& literal : clause) {
    std::vector<Term> arguments;
    for (const Term& argument : literal.atom.arguments()) {
      arguments.push_back(Rewrite(argument, steps));
    }
    literal.atom = Atom(literal.atom.predicate(), arguments);
  }
  const std::size_t before = clause.size();
  std::erase_if(clause, [&](const Literal& each) { return IsFalse(each) || IsCut(each); });
  return steps > 0 || clause.size() < before;
}

Term SmallSimplifier::Rewrite(const Term& term, std::size_t& steps) const {
  Term result = term;
  while (steps < kMostRewrites && !result.is_variable()) {
    if (result.kind() == Term::Kind::kCompound) {
      std::vector<Term> arguments;
      for (const Term& argument : result.arguments()) arguments.push_back(Rewrite(argument, steps));
      result = Term::Compound(result.symbol(), std::move(arguments));
    }
    if (!RewriteOnce(result)) break;
    ++steps;
  }
  return result;
}

bool SmallSimplifier::RewriteOnce(Term& term) const {
  for (const Literal& equation : equations_) {
    for (const Atom& reading : Readings(equation)) {
      Bindings bindings;
      if (!Match(reading.argument(0), term, bindings)) continue;
      const Term by = Substitute(reading.argument(1), bindings);
      if (!IsGreater(term, by)) continue;
      term = by;
      return true;
    }
  }
  return false;
}

bool SmallSimplifier::IsCut(const Literal& literal) const {
  const Literals& units = IsEquation(literal) && !literal.positive ? equations_ : units_;
  return std::any_of(units.begin(), units.end(), [&](const Literal& unit) {
    if (unit.positive == literal.positive) return false;
    const auto readings = Readings(unit);
    return std::any_of(readings.begin(), readings.end(), [&](const Atom& reading) {
      Bindings bindings;
      return Match(reading, literal.atom, bindings);
    });
  });
}

bool Subsumes(const Literals& general, const Literals& special) {
  return general.size() <= special.size() && Subsumption(general, special).From(0, {});
}

}  // namespace latchwork::check_proof
