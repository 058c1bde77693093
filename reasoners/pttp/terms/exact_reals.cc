// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/terms/exact_reals.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace latchwork::pttp {
namespace {

using Function = logic::Arithmetic::Function;

constexpr std::int64_t kMostExactInteger = std::int64_t{1} << 53U;
constexpr int kMostDecimals = 22;         // 5^22 is below 2^53.
constexpr double kLeastProduct = 1e-290;  // Below, the error of a product may be lost as well.

bool IsExactSum(double a, double b) {
  const double sum = a + b;
  const double from_b = sum - a;
  const double error = (a - (sum - from_b)) + (b - from_b);
  return error == 0.0;
}

bool IsExactProduct(double a, double b) {
  const double product = a * b;
  if (a == 0.0 || b == 0.0) return true;
  return std::fabs(product) >= kLeastProduct && std::fma(a, b, -product) == 0.0;
}

bool IsExactQuotient(double a, double b) {
  if (b == 0.0) return false;
  const double quotient = a / b;
  return a == 0.0 || (std::fabs(a) >= kLeastProduct && std::fma(quotient, b, -a) == 0.0);
}

bool AreIntegers(const Number* numbers, std::size_t arity) {
  return std::all_of(numbers, numbers + arity,
                     [](const Number& number) { return number.tag == Tag::kInteger; });
}

bool IsExactOfIntegers(Function function, const Number* numbers) {
  const auto value = [&](std::size_t i) { return std::bit_cast<std::int64_t>(numbers[i].bits); };
  if (function == Function::kToReal) return numbers[0].IsExact();
  if (function != Function::kQuotient) return true;
  return value(1) != 0 && value(1) != -1 && value(0) % value(1) == 0;
}

/// Functions of reals that round nothing by themselves.
bool KeepsReals(Function function) {
  switch (function) {
    case Function::kSum:
    case Function::kDifference:
    case Function::kProduct:
    case Function::kQuotient:
    case Function::kQuotientE:
    case Function::kRemainderE:
      return false;
    default:
      return true;
  }
}

}  // namespace

bool IsExactNumeral(double value) {
  std::array<char, 32> buffer{};  // d.ddde+xx, as short as it can be.
  const char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                        std::chars_format::scientific)
                              .ptr;
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  const std::size_t mark = text.find('e');
  std::int64_t digits = 0;
  int decimals = 0;
  bool behind_point = false;
  for (const char c : text.substr(0, mark)) {
    if (c == '.') behind_point = true;
    if (c < '0' || c > '9') continue;
    digits = digits * 10 + (c - '0');
    decimals += behind_point ? 1 : 0;
  }
  int exponent = 0;
  const char* const start = text.data() + mark + (text[mark + 1] == '+' ? 2 : 1);
  std::from_chars(start, end, exponent);
  decimals -= exponent;
  for (; decimals > 0 && digits % 10 == 0 && digits != 0; --decimals) digits /= 10;
  if (digits == 0) return true;
  if (decimals <= 0) return std::fabs(value) <= static_cast<double>(kMostExactInteger);
  if (decimals > kMostDecimals) return false;
  for (int i = 0; i < decimals; ++i) {
    if (digits % 5 != 0) return false;
    digits /= 5;
  }
  return true;
}

bool IsExact(Function function, const Number* numbers, std::size_t arity) {
  if (AreIntegers(numbers, arity)) return IsExactOfIntegers(function, numbers);
  if (KeepsReals(function)) return true;
  if (!numbers[0].IsExact() || !numbers[1].IsExact()) return false;
  const double a = numbers[0].value();
  const double b = numbers[1].value();
  switch (function) {
    case Function::kSum:
      return IsExactSum(a, b);
    case Function::kDifference:
      return IsExactSum(a, -b);
    case Function::kProduct:
      return IsExactProduct(a, b);
    case Function::kQuotient:
      return IsExactQuotient(a, b);
    default:
      return false;
  }
}

bool AllowsRoundedNumerals(Function function, const Number* numbers, std::size_t arity) {
  return AreIntegers(numbers, arity) ? IsExactOfIntegers(function, numbers) : KeepsReals(function);
}

}  // namespace latchwork::pttp
