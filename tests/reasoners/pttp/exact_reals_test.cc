// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/terms/exact_reals.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace latchwork::pttp {
namespace {

using Function = logic::Arithmetic::Function;

bool Exact(Function function, double a, double b) {
  const std::array<Number, 2> numbers = {Number::Real(a), Number::Real(b)};
  return IsExact(function, numbers.data(), numbers.size());
}

TEST(ExactRealsTest, Numerals_AreExactWhenTheirDecimalsAreHalvings) {
  for (const double value : {0.0, 1.0, -3.0, 0.5, 0.75, -0.125, 1e15, 1234.0625, 100.0}) {
    EXPECT_TRUE(IsExactNumeral(value)) << value;
  }
  for (const double value : {0.1, -0.3, 1.1, 1e-7, 1e300, 0.30000000000000004, 5e-324}) {
    EXPECT_FALSE(IsExactNumeral(value)) << value;
  }
}

/// The sum of such numbers has at most 64 bits, which a long double holds.
TEST(ExactRealsTest, Sums_AreExactWhereMorePreciseOnesAreTheSame) {
  std::mt19937_64 draw(7);
  std::size_t rounded = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto number = [&] {
      const auto bits = static_cast<std::int64_t>(draw() >> (11 + draw() % 52));
      return std::ldexp(static_cast<double>(bits), static_cast<int>(draw() % 9) - 4);
    };
    const double a = number();
    const double b = number();
    const bool fits = static_cast<long double>(a + b) ==
                      static_cast<long double>(a) + static_cast<long double>(b);
    EXPECT_EQ(Exact(Function::kSum, a, b), fits) << a << ' ' << b;
    EXPECT_EQ(Exact(Function::kDifference, a, -b), fits) << a << ' ' << b;
    rounded += fits ? 0 : 1;
  }
  EXPECT_GT(rounded, 100U);
}

TEST(ExactRealsTest, ProductsAndQuotients_AreExactWhereNoBitIsLost) {
  EXPECT_TRUE(Exact(Function::kProduct, 1.5, -2.0));
  EXPECT_TRUE(Exact(Function::kProduct, 0.0, 0.1));
  EXPECT_FALSE(Exact(Function::kProduct, 0.1, 0.1));
  EXPECT_FALSE(Exact(Function::kProduct, 1e-200, 1e-200));
  EXPECT_TRUE(Exact(Function::kQuotient, 1.5, 2.0));
  EXPECT_FALSE(Exact(Function::kQuotient, 1.0, 3.0));
  EXPECT_FALSE(Exact(Function::kQuotient, 1.0, 0.0));
}

TEST(ExactRealsTest, RoundedNumerals_AreComparedButNotAdded) {
  const std::array<Number, 2> numbers = {Number::Real(0.1), Number::Real(0.2)};
  EXPECT_FALSE(AllowsRoundedNumerals(Function::kSum, numbers.data(), 2));
  EXPECT_FALSE(AllowsRoundedNumerals(Function::kQuotientE, numbers.data(), 2));
  EXPECT_TRUE(AllowsRoundedNumerals(Function::kMax, numbers.data(), 2));
  EXPECT_TRUE(AllowsRoundedNumerals(Function::kFloor, numbers.data(), 1));
}

}  // namespace
}  // namespace latchwork::pttp
