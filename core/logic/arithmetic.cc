// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/arithmetic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/logic/interpreted.h"
#include "core/logic/rebuild_term.h"

namespace latchwork::logic {

namespace {

using Function = Arithmetic::Function;
using Predicate = Arithmetic::Predicate;
using Value = std::optional<Term>;

constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();

/// A number as a term; zero has one sign, and what is not finite is no value.
Value Real(double value) {
  if (!std::isfinite(value)) return std::nullopt;
  return Term::Real(value == 0.0 ? 0.0 : value);
}

/// To the nearest integral value, halves to the even one, whatever the rounding mode.
double RoundToEven(double value) { return value - std::remainder(value, 1.0); }

Value ToInteger(double value) {
  constexpr double kBound = 9223372036854775808.0;
  if (!(value >= -kBound && value < kBound)) return std::nullopt;
  return Term::Integer(static_cast<std::int64_t>(value));
}

std::int64_t EuclideanRemainder(std::int64_t a, std::int64_t b) {
  if (b == -1) return 0;
  const std::int64_t remainder = a % b;
  if (remainder >= 0) return remainder;
  return b > 0 ? remainder + b : remainder - b;
}

double EuclideanRemainder(double a, double b) {
  const double remainder = std::fmod(a, b);
  return remainder < 0 ? remainder + std::fabs(b) : remainder;
}

Value Divide(Function function, std::int64_t a, std::int64_t b) {
  if (b == 0 || (a == kLeast && b == -1 && function != Function::kRemainderE)) return std::nullopt;
  if (function == Function::kRemainderE) return Term::Integer(EuclideanRemainder(a, b));
  if (function == Function::kQuotientE) {
    const std::int64_t quotient = a / b;
    if (a % b >= 0) return Term::Integer(quotient);
    return Term::Integer(b > 0 ? quotient - 1 : quotient + 1);
  }
  if (a % b == 0) return Term::Integer(a / b);
  return Real(static_cast<double>(a) / static_cast<double>(b));
}

Value Divide(Function function, double a, double b) {
  if (b == 0.0) return std::nullopt;
  if (function == Function::kQuotient) return Real(a / b);
  const double remainder = EuclideanRemainder(a, b);
  return Real(function == Function::kRemainderE ? remainder : RoundToEven((a - remainder) / b));
}

Value Apply(Function function, std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  bool overflow = false;
  switch (function) {
    case Function::kSum:
      overflow = __builtin_add_overflow(a, b, &result);
      break;
    case Function::kDifference:
      overflow = __builtin_sub_overflow(a, b, &result);
      break;
    case Function::kProduct:
      overflow = __builtin_mul_overflow(a, b, &result);
      break;
    case Function::kMin:
      result = std::min(a, b);
      break;
    case Function::kMax:
      result = std::max(a, b);
      break;
    default:
      return Divide(function, a, b);
  }
  if (overflow) return std::nullopt;
  return Term::Integer(result);
}

Value Apply(Function function, double a, double b) {
  switch (function) {
    case Function::kSum:
      return Real(a + b);
    case Function::kDifference:
      return Real(a - b);
    case Function::kProduct:
      return Real(a * b);
    case Function::kMin:
      return Real(std::min(a, b));
    case Function::kMax:
      return Real(std::max(a, b));
    default:
      return Divide(function, a, b);
  }
}

Value Apply(Function function, std::int64_t a) {
  if (function == Function::kToReal) return Real(static_cast<double>(a));
  if (function != Function::kUminus && function != Function::kAbs) return Term::Integer(a);
  if (a == kLeast) return std::nullopt;
  return Term::Integer(function == Function::kUminus || a < 0 ? -a : a);
}

Value Apply(Function function, double a) {
  switch (function) {
    case Function::kUminus:
      return Real(-a);
    case Function::kToInt:
      return ToInteger(std::floor(a));
    case Function::kToReal:
      return Real(a);
    case Function::kFloor:
      return Real(std::floor(a));
    case Function::kCeiling:
      return Real(std::ceil(a));
    case Function::kRound:
      return Real(RoundToEven(a));
    case Function::kTruncate:
      return Real(std::trunc(a));
    default:
      return Real(std::fabs(a));
  }
}

bool AreNumbers(std::span<const Term> terms, std::size_t arity) {
  return terms.size() == arity && std::all_of(terms.begin(), terms.end(), [](const Term& term) {
           return term.is_number() && std::isfinite(term.number());
         });
}

bool AreIntegers(std::span<const Term> terms) {
  return std::all_of(terms.begin(), terms.end(),
                     [](const Term& term) { return term.kind() == Term::Kind::kInteger; });
}

template <typename Number>
bool Compare(Predicate predicate, Number a, Number b) {
  switch (predicate) {
    case Predicate::kLess:
      return a < b;
    case Predicate::kLessEq:
      return a <= b;
    case Predicate::kGreater:
      return a > b;
    default:
      return a >= b;
  }
}

template <typename Index, std::size_t kCount>
std::optional<Index> Find(const std::vector<Symbol>& symbols,
                          const std::array<InterpretedName, kCount>& names, Symbol symbol,
                          std::size_t arity) {
  const auto found = std::find(symbols.begin(), symbols.end(), symbol);
  if (found == symbols.end()) return std::nullopt;
  const auto index = static_cast<std::size_t>(found - symbols.begin());
  if (names[index].arity != arity) return std::nullopt;
  return static_cast<Index>(index);
}

}  // namespace

Arithmetic::Arithmetic(SymbolTable& symbols) {
  for (const auto& each : kInterpretedPredicates) predicates_.push_back(symbols.Intern(each.name));
  for (const auto& each : kInterpretedFunctions) functions_.push_back(symbols.Intern(each.name));
}

std::optional<Predicate> Arithmetic::FindPredicate(Symbol symbol, std::size_t arity) const {
  return Find<Predicate>(predicates_, kInterpretedPredicates, symbol, arity);
}

std::optional<Function> Arithmetic::FindFunction(Symbol symbol, std::size_t arity) const {
  return Find<Function>(functions_, kInterpretedFunctions, symbol, arity);
}

std::optional<bool> Arithmetic::Evaluate(Predicate predicate, std::span<const Term> numbers) {
  const std::size_t arity = kInterpretedPredicates[static_cast<std::size_t>(predicate)].arity;
  if (!AreNumbers(numbers, arity)) return std::nullopt;
  if (predicate == Predicate::kIsReal) return true;
  if (predicate == Predicate::kIsInt) {
    return AreIntegers(numbers) || std::floor(numbers[0].real()) == numbers[0].real();
  }
  if (AreIntegers(numbers)) return Compare(predicate, numbers[0].integer(), numbers[1].integer());
  return Compare(predicate, numbers[0].number(), numbers[1].number());
}

std::optional<bool> Arithmetic::Evaluate(Predicate predicate, double a, double b) {
  if (kInterpretedPredicates[static_cast<std::size_t>(predicate)].arity != 2) return std::nullopt;
  return Compare(predicate, a, b);
}

std::optional<Term> Arithmetic::Evaluate(Function function, std::span<const Term> numbers) {
  const std::size_t arity = kInterpretedFunctions[static_cast<std::size_t>(function)].arity;
  if (!AreNumbers(numbers, arity)) return std::nullopt;
  const bool integers = AreIntegers(numbers);
  if (arity == 1) {
    return integers ? Apply(function, numbers[0].integer()) : Apply(function, numbers[0].real());
  }
  return integers ? Apply(function, numbers[0].integer(), numbers[1].integer())
                  : Apply(function, numbers[0].number(), numbers[1].number());
}

std::optional<Term> Arithmetic::Normalize(const Term& term) const {
  const auto replace = [](const Term& part) -> Value {
    if (part.kind() == Term::Kind::kCompound) return std::nullopt;
    return part;
  };
  const auto join = [this](Symbol symbol, std::vector<Term> arguments) -> Value {
    if (const auto function = FindFunction(symbol, arguments.size())) {
      return Evaluate(*function, arguments);
    }
    return Term::Compound(symbol, std::move(arguments));
  };
  return RebuildTerm(term, replace, join);
}

}  // namespace latchwork::logic
