// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_ARITHMETIC_H_
#define LATCHWORK_LOGIC_ARITHMETIC_H_

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/logic/term.h"

namespace latchwork::logic {

/// The interpreted symbols of TPTP's TFF arithmetic, over 64-bit integers and IEEE doubles.
/// Mixed arguments (an integer and a real) are computed as reals. An integer overflow, a division
/// by zero or a result that is not finite is no value. `$quotient` of integers is a real unless it
/// is exact.
class Arithmetic {
 public:
  explicit Arithmetic(SymbolTable& symbols);

  enum class Predicate : unsigned char { kLess, kLessEq, kGreater, kGreaterEq, kIsInt, kIsReal };
  enum class Function : unsigned char {
    kSum,
    kDifference,
    kProduct,
    kQuotient,
    kUminus,
    kToInt,
    kToReal,
    kFloor,
    kCeiling,
    kRound,
    kTruncate,
    kQuotientE,
    kRemainderE,
    kAbs,
    kMin,
    kMax,
  };

  /// Which interpreted symbol this is, at this arity; nothing for any other symbol.
  std::optional<Predicate> FindPredicate(Symbol symbol, std::size_t arity) const;
  std::optional<Function> FindFunction(Symbol symbol, std::size_t arity) const;

  /// Nothing when an argument is not a number or the result is no value.
  static std::optional<bool> Evaluate(Predicate predicate, std::span<const Term> numbers);
  /// The same for two finite reals.
  static std::optional<bool> Evaluate(Predicate predicate, double a, double b);
  static std::optional<Term> Evaluate(Function function, std::span<const Term> numbers);
  /// Evaluates every interpreted function in a ground term, innermost first; nothing when one has
  /// no value.
  std::optional<Term> Normalize(const Term& term) const;

 private:
  std::vector<Symbol> predicates_;  ///< Indexed by Predicate.
  std::vector<Symbol> functions_;   ///< Indexed by Function.
};

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_ARITHMETIC_H_
