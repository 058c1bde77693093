// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reasoners/pttp/random_clauses.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "latchwork/sdk/random.h"

namespace latchwork::pttp {
namespace {

/// Literals by their bits: which atoms, and which negated atoms, make a clause true.
struct GroundClause {
  std::uint64_t positive = 0;
  std::uint64_t negative = 0;
};

/// Davis, Logemann and Loveland 1962 on bits.
bool HasModel(const std::vector<GroundClause>& clauses, std::uint64_t yes, std::uint64_t no) {
  std::uint64_t choice = 0;
  for (bool changed = true; changed;) {
    changed = false;
    choice = 0;
    for (const GroundClause& clause : clauses) {
      if ((clause.positive & yes) != 0 || (clause.negative & no) != 0) continue;
      const std::uint64_t positive = clause.positive & ~no;
      const std::uint64_t negative = clause.negative & ~yes;
      if (positive == 0 && negative == 0) return false;
      if (std::popcount(positive) + std::popcount(negative) == 1) {
        yes |= positive;
        no |= negative;
        changed = true;
      } else {
        const std::uint64_t either = positive | negative;
        choice = either & (~either + 1);
      }
    }
  }
  return choice == 0 || HasModel(clauses, yes | choice, no) || HasModel(clauses, yes, no | choice);
}

/// Numbers of objects, what constants and `f` are, and a bit for every atom.
struct Universe {
  std::size_t size = 1;
  std::array<std::size_t, 2> constants{};
  std::array<std::optional<std::size_t>, 4> image{};  ///< Of f; nothing: outside.
  bool equality_is_identity = true;

  std::optional<std::size_t> Value(const RandomTerm& term,
                                   const std::array<std::size_t, kVariables>& assignment) const {
    std::optional<std::size_t> value =
        term.base < 2 ? constants[term.base] : assignment[term.base - 2];
    for (std::size_t i = 0; value && i < term.wrapped; ++i) value = image[*value];
    return value;
  }

  std::uint64_t Bit(std::size_t predicate, std::size_t a, std::size_t b) const {
    static constexpr std::array<std::size_t, 6> kFirst{0, 1, 2, 6, 10, 26};
    const std::size_t arity = kArities[predicate];
    const std::size_t offset = arity == 0 ? 0 : arity == 1 ? a : 4 * a + b;
    return std::uint64_t{1} << (kFirst[predicate] + offset);
  }
};

/// Adds the clause under an assignment, unless it is true or speaks of what is outside.
void AddInstance(const Universe& universe, const RandomClause& clause,
                 const std::array<std::size_t, kVariables>& assignment,
                 std::vector<GroundClause>& result) {
  GroundClause ground;
  for (const RandomLiteral& literal : clause) {
    const auto a = universe.Value(literal.arguments[0], assignment);
    const auto b = universe.Value(literal.arguments[1], assignment);
    const std::size_t arity = kArities[literal.predicate];
    if ((arity > 0 && !a) || (arity > 1 && !b)) return;
    if (literal.predicate == kEquality && universe.equality_is_identity) {
      if ((*a == *b) == literal.positive) return;
      continue;
    }
    const std::uint64_t bit = universe.Bit(literal.predicate, a.value_or(0), b.value_or(0));
    (literal.positive ? ground.positive : ground.negative) |= bit;
  }
  if ((ground.positive & ground.negative) == 0) result.push_back(ground);
}

std::vector<GroundClause> Ground(const Universe& universe,
                                 const std::vector<RandomClause>& clauses) {
  std::vector<GroundClause> result;
  std::array<std::size_t, kVariables> assignment{};
  for (const RandomClause& clause : clauses) {
    for (assignment[0] = 0; assignment[0] < universe.size; ++assignment[0]) {
      for (assignment[1] = 0; assignment[1] < universe.size; ++assignment[1]) {
        for (assignment[2] = 0; assignment[2] < universe.size; ++assignment[2]) {
          AddInstance(universe, clause, assignment, result);
        }
      }
    }
  }
  return result;
}

bool HasSmallModel(const std::vector<RandomClause>& clauses, std::size_t size) {
  Universe universe;
  universe.size = size;
  // One number for each way to choose a, b, f(0) and f(1).
  for (std::size_t way = 0; way < size * size * size * size; ++way) {
    universe.constants = {way % size, way / size % size};
    universe.image = {way / size / size % size, way / size / size / size, {}, {}};
    if (HasModel(Ground(universe, clauses), 0, 0)) return true;
  }
  return false;
}

/// The axioms of equality over the terms of a universe.
void AddEquality(const Universe& universe, std::vector<GroundClause>& clauses) {
  const auto equal = [&](std::size_t a, std::size_t b) { return universe.Bit(kEquality, a, b); };
  for (std::size_t a = 0; a < universe.size; ++a) {
    clauses.push_back({equal(a, a), 0});
    for (std::size_t b = 0; b < universe.size; ++b) {
      clauses.push_back({equal(b, a), equal(a, b)});
      if (universe.image[a] && universe.image[b]) {
        clauses.push_back({equal(*universe.image[a], *universe.image[b]), equal(a, b)});
      }
      for (const std::size_t predicate : {std::size_t{2}, std::size_t{3}}) {
        clauses.push_back(
            {universe.Bit(predicate, b, 0), equal(a, b) | universe.Bit(predicate, a, 0)});
      }
      for (std::size_t c = 0; c < universe.size; ++c) {
        clauses.push_back({equal(a, c), equal(a, b) | equal(b, c)});
        clauses.push_back({universe.Bit(4, b, c), equal(a, b) | universe.Bit(4, a, c)});
        clauses.push_back({universe.Bit(4, c, b), equal(a, b) | universe.Bit(4, c, a)});
      }
    }
  }
}

bool HasModelOfInstances(const std::vector<RandomClause>& clauses, bool equality) {
  Universe universe;
  universe.size = 4;
  universe.constants = {0, 1};
  universe.image = {2, 3, {}, {}};
  universe.equality_is_identity = false;
  std::vector<GroundClause> ground = Ground(universe, clauses);
  if (equality) AddEquality(universe, ground);
  return HasModel(ground, 0, 0);
}

class Maker {
 public:
  Maker(const Language& language, std::uint64_t number) : language_(language), number_(number) {}

  std::vector<RandomClause> Make() {
    std::vector<RandomClause> clauses(3 + Pick(7));
    for (RandomClause& clause : clauses) {
      clause.resize(1 + Pick(3));
      for (RandomLiteral& literal : clause) literal = MakeLiteral();
    }
    return clauses;
  }

 private:
  RandomLiteral MakeLiteral() {
    RandomLiteral literal;
    literal.positive = Pick(2) == 0;
    literal.predicate = language_.variables ? 1 + Pick(4) : Pick(5);
    if (language_.equality && Pick(3) == 0) literal.predicate = kEquality;
    for (RandomTerm& term : literal.arguments) {
      term.base = Pick(language_.variables ? 2 + kVariables : 2);
      if (language_.functions && Pick(3) == 0) term.wrapped = 1 + Pick(5) / 4;
    }
    return literal;
  }

  std::size_t Pick(std::size_t count) {
    return static_cast<std::size_t>(stream_.Index(count, number_, draws_++));
  }

  Language language_;
  sdk::RandomStream stream_{7, "clauses"};
  std::uint64_t number_;
  std::uint64_t draws_ = 0;
};

std::string Text(const RandomTerm& term) {
  static constexpr std::array<const char*, 2 + kVariables> kBases{"a", "b", "X", "Y", "Z"};
  std::string text = kBases[term.base];
  for (std::size_t i = 0; i < term.wrapped; ++i) text = "f(" + text + ")";
  return text;
}

std::string Text(const RandomLiteral& literal) {
  static constexpr std::array<const char*, 5> kPredicates{"s", "t", "p", "q", "r"};
  const std::string a = Text(literal.arguments[0]);
  const std::string b = Text(literal.arguments[1]);
  if (literal.predicate == kEquality) return a + (literal.positive ? " = " : " != ") + b;
  std::string text = literal.positive ? "" : "~ ";
  text += kPredicates[literal.predicate];
  const std::size_t arity = kArities[literal.predicate];
  if (arity == 0) return text;
  return text + "(" + a + (arity > 1 ? "," + b : "") + ")";
}

}  // namespace

std::vector<RandomClause> MakeRandomClauses(const Language& language, std::uint64_t number) {
  return Maker(language, number).Make();
}

std::string Text(const std::vector<RandomClause>& clauses) {
  std::string text;
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    text += "cnf(c" + std::to_string(i) + ", axiom, ";
    for (std::size_t j = 0; j < clauses[i].size(); ++j) {
      text += (j > 0 ? " | " : "") + Text(clauses[i][j]);
    }
    text += ").\n";
  }
  return text;
}

Truth JudgeByBruteForce(const std::vector<RandomClause>& clauses, const Language& language) {
  if (HasSmallModel(clauses, 1) || HasSmallModel(clauses, 2)) return Truth::kSatisfiable;
  if (!language.functions) return Truth::kUnsatisfiable;
  return HasModelOfInstances(clauses, language.equality) ? Truth::kUnknown : Truth::kUnsatisfiable;
}

}  // namespace latchwork::pttp
