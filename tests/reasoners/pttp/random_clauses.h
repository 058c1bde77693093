// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_PTTP_RANDOM_CLAUSES_H_
#define LATCHWORK_TESTS_REASONERS_PTTP_RANDOM_CLAUSES_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace latchwork::pttp {

/// What random clauses are made of.
struct Language {
  bool variables = false;
  bool functions = false;
  bool equality = false;
};

/// A constant (0: a, 1: b) or a variable (2: X, 3: Y, 4: Z), below `f` as often as `wrapped` says.
struct RandomTerm {
  std::size_t base = 0;
  std::size_t wrapped = 0;
};

/// s, t, p(X), q(X), r(X, Y) or X = Y.
struct RandomLiteral {
  bool positive = true;
  std::size_t predicate = 0;
  std::array<RandomTerm, 2> arguments{};
};
using RandomClause = std::vector<RandomLiteral>;

inline constexpr std::size_t kVariables = 3;
inline constexpr std::array<std::size_t, 6> kArities{0, 0, 1, 1, 2, 2};
inline constexpr std::size_t kEquality = 5;

/// The same clauses for the same number.
std::vector<RandomClause> MakeRandomClauses(const Language& language, std::uint64_t number);

/// As TPTP.
std::string Text(const std::vector<RandomClause>& clauses);

enum class Truth : std::uint8_t { kUnknown, kSatisfiable, kUnsatisfiable };

/// By trying all models with one or two elements, and, where there are functions, all instances
/// over a, b, f(a) and f(b). Without functions it is always known.
Truth JudgeByBruteForce(const std::vector<RandomClause>& clauses, const Language& language);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_TESTS_REASONERS_PTTP_RANDOM_CLAUSES_H_
