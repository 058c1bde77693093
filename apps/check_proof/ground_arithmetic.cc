// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/ground_arithmetic.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/check_proof/entailment.h"

namespace latchwork::check_proof {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;
using logic::Literal;
using logic::Term;

constexpr int kDeepest = 500;
constexpr unsigned kMostBits = 1U << 14U;

/// What cannot be computed here; nothing is said of the clause.
struct TooHard {};

struct Number {
  bool is_integer = false;
  Rational value;

  bool operator==(const Number&) const = default;
};

/// A term with all its numbers computed.
struct Computed {
  std::optional<Number> number;  ///< Else:
  std::string symbol;
  std::vector<Computed> arguments;

  bool operator==(const Computed&) const = default;
};

Integer PowerOfTen(std::int64_t exponent) {
  return boost::multiprecision::pow(Integer(10), static_cast<unsigned>(exponent));
}

/// As the numeral is written.
Rational ReadDecimal(const std::string& text) {
  const std::size_t mark = std::min(text.find('e'), text.size());
  std::int64_t exponent = mark < text.size() ? std::stoll(text.substr(mark + 1)) : 0;
  Integer digits{0};
  bool behind_point = false;
  for (const char c : std::string_view{text}.substr(0, mark)) {
    if (c == '.') behind_point = true;
    if (c < '0' || c > '9') continue;
    digits = digits * 10 + (c - '0');
    if (behind_point) --exponent;
  }
  if (text.starts_with('-')) digits = -digits;
  return exponent >= 0 ? Rational(digits * PowerOfTen(exponent))
                       : Rational(digits, PowerOfTen(-exponent));
}

Integer Floor(const Rational& value) {
  const Integer above = numerator(value);
  const Integer below = denominator(value);  // Positive.
  Integer quotient = above / below;
  if (above < 0 && quotient * below != above) --quotient;
  return quotient;
}

Integer Ceiling(const Rational& value) { return -Floor(-value); }

/// To the nearest, halves to the even one.
Integer Round(const Rational& value) {
  const Integer floor = Floor(value);
  const Rational rest = value - Rational(floor);
  const Rational half(1, 2);
  if (rest == half) return floor % 2 == 0 ? floor : Integer(floor + 1);
  return rest < half ? floor : Integer(floor + 1);
}

std::optional<Number> Apply(std::string_view function, const Number& a) {
  const auto keep = [&](Rational value) { return Number{a.is_integer, std::move(value)}; };
  if (function == "$uminus") return keep(-a.value);
  if (function == "$abs") return keep(abs(a.value));
  if (function == "$to_real") return Number{false, a.value};
  if (function == "$to_int") return Number{true, Rational(Floor(a.value))};
  if (function == "$floor") return keep(Rational(Floor(a.value)));
  if (function == "$ceiling") return keep(Rational(Ceiling(a.value)));
  if (function == "$round") return keep(Rational(Round(a.value)));
  if (function == "$truncate") {
    return keep(Rational(a.value < 0 ? Ceiling(a.value) : Floor(a.value)));
  }
  return std::nullopt;
}

/// The quotient whose remainder is not negative.
Integer EuclideanQuotient(const Rational& a, const Rational& b) {
  return b > 0 ? Floor(a / b) : Ceiling(a / b);
}

std::optional<Number> Divide(std::string_view function, const Number& a, const Number& b) {
  if (b.value == 0) return std::nullopt;
  const bool integers = a.is_integer && b.is_integer;
  if (function == "$quotient") {
    const Rational quotient = a.value / b.value;
    return Number{integers && denominator(quotient) == 1, quotient};
  }
  const Rational quotient(EuclideanQuotient(a.value, b.value));
  if (function == "$quotient_e") return Number{integers, quotient};
  if (function == "$remainder_e") return Number{integers, a.value - quotient * b.value};
  return std::nullopt;
}

std::optional<Number> Apply(std::string_view function, const Number& a, const Number& b) {
  const bool integers = a.is_integer && b.is_integer;
  if (function == "$sum") return Number{integers, a.value + b.value};
  if (function == "$difference") return Number{integers, a.value - b.value};
  if (function == "$product") return Number{integers, a.value * b.value};
  if (function == "$min") return Number{integers, std::min(a.value, b.value)};
  if (function == "$max") return Number{integers, std::max(a.value, b.value)};
  return Divide(function, a, b);
}

bool IsTooLarge(const Number& number) {
  const auto is_long = [](const Integer& part) { return part != 0 && msb(abs(part)) > kMostBits; };
  return is_long(numerator(number.value)) || is_long(denominator(number.value));
}

std::optional<Number> Apply(std::string_view function, const std::vector<Computed>& arguments) {
  if (std::ranges::any_of(arguments, [](const Computed& c) { return !c.number; })) return {};
  std::optional<Number> result;
  if (arguments.size() == 1) result = Apply(function, *arguments[0].number);
  if (arguments.size() == 2) result = Apply(function, *arguments[0].number, *arguments[1].number);
  if (result && IsTooLarge(*result)) throw TooHard();
  return result;
}

Computed Compute(const Term& term, int depth = 0) {
  if (depth > kDeepest) throw TooHard();
  if (term.kind() == Term::Kind::kInteger) return {Number{true, Rational(term.integer())}, {}, {}};
  if (term.kind() == Term::Kind::kReal) return {Number{false, ReadDecimal(ToString(term))}, {}, {}};
  if (term.is_variable()) return {{}, ToString(term), {}};
  Computed computed{{}, logic::QuoteWord(term.symbol().name()), {}};
  for (const Term& argument : term.arguments()) {
    computed.arguments.push_back(Compute(argument, depth + 1));
  }
  if (auto number = Apply(term.symbol().name(), computed.arguments)) return {number, {}, {}};
  return computed;
}

std::optional<bool> Compare(std::string_view predicate, const Rational& a, const Rational& b) {
  if (predicate == "$less") return a < b;
  if (predicate == "$lesseq") return a <= b;
  if (predicate == "$greater") return a > b;
  if (predicate == "$greatereq") return a >= b;
  return std::nullopt;
}

/// Whether the atom is true; nothing: arithmetic does not say.
std::optional<bool> TruthOf(std::string_view predicate, const std::vector<Computed>& arguments) {
  if (arguments.size() == 1 && arguments[0].number) {
    if (predicate == "$is_real") return true;
    if (predicate == "$is_int") return denominator(arguments[0].number->value) == 1;
  }
  if (arguments.size() != 2) return std::nullopt;
  if (predicate == "=" && arguments[0] == arguments[1]) return true;
  if (!arguments[0].number || !arguments[1].number) return std::nullopt;
  const Rational& a = arguments[0].number->value;
  const Rational& b = arguments[1].number->value;
  if (predicate != "=") return Compare(predicate, a, b);
  return a != b ? std::optional(false) : std::nullopt;
}

struct Side {
  bool positive;
  std::string predicate;
  std::vector<Computed> arguments;
};

Side SideOf(const Literal& literal) {
  Side side{literal.positive, std::string(literal.atom.predicate().name()), {}};
  for (const Term& argument : literal.atom.arguments()) side.arguments.push_back(Compute(argument));
  return side;
}

bool AreOpposite(const Side& a, const Side& b) {
  return a.positive != b.positive && a.predicate == b.predicate && a.arguments == b.arguments;
}

bool IsTrue(const std::vector<Literal>& literals) {
  std::vector<Side> sides;
  for (const Literal& literal : literals) {
    const Side side = SideOf(literal);
    if (TruthOf(side.predicate, side.arguments) == side.positive) return true;
    const auto is_opposite = [&](const Side& other) { return AreOpposite(other, side); };
    if (std::ranges::any_of(sides, is_opposite)) return true;
    sides.push_back(side);
  }
  return false;
}

}  // namespace

Verdict IsTrueByArithmetic(const logic::Formula& clause) {
  std::vector<Literal> literals;
  if (!ToLiterals(clause, literals)) return Verdict::kTooHard;
  try {
    return IsTrue(literals) ? Verdict::kYes : Verdict::kNo;
  } catch (const TooHard&) {
    return Verdict::kTooHard;
  }
}

}  // namespace latchwork::check_proof
