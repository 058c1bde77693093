// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/arithmetic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace latchwork::logic {
namespace {

using Function = Arithmetic::Function;
using Predicate = Arithmetic::Predicate;

constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kGreatest = std::numeric_limits<std::int64_t>::max();

Term I(std::int64_t value) { return Term::Integer(value); }
Term R(double value) { return Term::Real(value); }

std::string Eval(Function function, std::vector<Term> numbers) {
  const auto value = Arithmetic::Evaluate(function, numbers);
  return value ? ToString(*value) : "none";
}

std::string Eval(Predicate predicate, std::vector<Term> numbers) {
  const auto value = Arithmetic::Evaluate(predicate, numbers);
  return !value ? "none" : *value ? "true" : "false";
}

TEST(ArithmeticTest, Integers_StayIntegers) {
  EXPECT_EQ(Eval(Function::kSum, {I(2), I(3)}), "5");
  EXPECT_EQ(Eval(Function::kDifference, {I(2), I(3)}), "-1");
  EXPECT_EQ(Eval(Function::kProduct, {I(-2), I(3)}), "-6");
  EXPECT_EQ(Eval(Function::kUminus, {I(2)}), "-2");
  EXPECT_EQ(Eval(Function::kAbs, {I(-2)}), "2");
  EXPECT_EQ(Eval(Function::kMin, {I(2), I(-3)}), "-3");
  EXPECT_EQ(Eval(Function::kMax, {I(2), I(-3)}), "2");
  EXPECT_EQ(Eval(Function::kFloor, {I(2)}), "2");
}

TEST(ArithmeticTest, Mixed_IsReal) {
  EXPECT_EQ(Eval(Function::kSum, {I(2), R(0.5)}), "2.5");
  EXPECT_EQ(Eval(Function::kMax, {I(3), R(0.5)}), "3.0");
  EXPECT_EQ(Eval(Predicate::kLess, {I(2), R(2.5)}), "true");
}

TEST(ArithmeticTest, IntegerOverflow_IsNoValue) {
  EXPECT_EQ(Eval(Function::kSum, {I(kGreatest), I(1)}), "none");
  EXPECT_EQ(Eval(Function::kDifference, {I(kLeast), I(1)}), "none");
  EXPECT_EQ(Eval(Function::kProduct, {I(kGreatest), I(2)}), "none");
  EXPECT_EQ(Eval(Function::kUminus, {I(kLeast)}), "none");
  EXPECT_EQ(Eval(Function::kAbs, {I(kLeast)}), "none");
  EXPECT_EQ(Eval(Function::kQuotient, {I(kLeast), I(-1)}), "none");
  EXPECT_EQ(Eval(Function::kQuotientE, {I(kLeast), I(-1)}), "none");
  EXPECT_EQ(Eval(Function::kRemainderE, {I(kLeast), I(-1)}), "0");
}

TEST(ArithmeticTest, Quotient_IsIntegerWhenExact) {
  EXPECT_EQ(Eval(Function::kQuotient, {I(6), I(3)}), "2");
  EXPECT_EQ(Eval(Function::kQuotient, {I(7), I(2)}), "3.5");
  EXPECT_EQ(Eval(Function::kQuotient, {R(6), I(3)}), "2.0");
}

TEST(ArithmeticTest, DivisionByZero_IsNoValue) {
  for (const Function function :
       {Function::kQuotient, Function::kQuotientE, Function::kRemainderE}) {
    EXPECT_EQ(Eval(function, {I(1), I(0)}), "none");
    EXPECT_EQ(Eval(function, {R(1), R(0)}), "none");
    EXPECT_EQ(Eval(function, {R(0), R(-0.0)}), "none");
  }
}

TEST(ArithmeticTest, EuclideanDivision_HasRemainderFromZero) {
  for (const std::int64_t a : {-7, 7}) {
    for (const std::int64_t b : {-3, 3}) {
      const auto q = Arithmetic::Evaluate(Function::kQuotientE, std::vector{I(a), I(b)});
      const auto r = Arithmetic::Evaluate(Function::kRemainderE, std::vector{I(a), I(b)});
      ASSERT_TRUE(q && r);
      EXPECT_GE(r->integer(), 0);
      EXPECT_LT(r->integer(), 3);
      EXPECT_EQ(q->integer() * b + r->integer(), a);
      const std::vector reals = {R(static_cast<double>(a)), R(static_cast<double>(b))};
      EXPECT_EQ(Arithmetic::Evaluate(Function::kQuotientE, reals)->real(), q->number());
      EXPECT_EQ(Arithmetic::Evaluate(Function::kRemainderE, reals)->real(), r->number());
    }
  }
}

TEST(ArithmeticTest, Rounding_FollowsTptp) {
  EXPECT_EQ(Eval(Function::kFloor, {R(-1.5)}), "-2.0");
  EXPECT_EQ(Eval(Function::kCeiling, {R(-1.5)}), "-1.0");
  EXPECT_EQ(Eval(Function::kTruncate, {R(-1.5)}), "-1.0");
  EXPECT_EQ(Eval(Function::kRound, {R(0.5)}), "0.0");
  EXPECT_EQ(Eval(Function::kRound, {R(1.5)}), "2.0");
  EXPECT_EQ(Eval(Function::kRound, {R(2.5)}), "2.0");
  EXPECT_EQ(Eval(Function::kToInt, {R(-1.5)}), "-2");
  EXPECT_EQ(Eval(Function::kToInt, {R(9.3e18)}), "none");
  EXPECT_EQ(Eval(Function::kToReal, {I(2)}), "2.0");
}

TEST(ArithmeticTest, NegativeZero_NeverComesOut) {
  EXPECT_EQ(Eval(Function::kUminus, {R(0)}), "0.0");
  EXPECT_EQ(Eval(Function::kProduct, {R(-1), R(0)}), "0.0");
  EXPECT_EQ(Eval(Function::kCeiling, {R(-0.5)}), "0.0");
  EXPECT_EQ(Eval(Function::kRound, {R(-0.5)}), "0.0");
  EXPECT_EQ(Eval(Function::kToReal, {R(-0.0)}), "0.0");
}

TEST(ArithmeticTest, NotFinite_IsNoValue) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Eval(Function::kProduct, {R(1e300), R(1e300)}), "none");
  EXPECT_EQ(Eval(Function::kQuotient, {R(1e300), R(1e-300)}), "none");
  EXPECT_EQ(Eval(Function::kDifference, {R(kInfinity), R(kInfinity)}), "none");
  EXPECT_EQ(Eval(Function::kAbs, {R(std::nan(""))}), "none");
  EXPECT_EQ(Eval(Predicate::kLess, {R(std::nan("")), R(1)}), "none");
}

TEST(ArithmeticTest, Comparisons_AreExactForIntegers) {
  EXPECT_EQ(Eval(Predicate::kLess, {I(kGreatest - 1), I(kGreatest)}), "true");
  EXPECT_EQ(Eval(Predicate::kLessEq, {I(1), I(1)}), "true");
  EXPECT_EQ(Eval(Predicate::kGreater, {I(1), I(1)}), "false");
  EXPECT_EQ(Eval(Predicate::kGreaterEq, {R(1), R(1)}), "true");
  EXPECT_EQ(Eval(Predicate::kIsInt, {R(2)}), "true");
  EXPECT_EQ(Eval(Predicate::kIsInt, {R(2.5)}), "false");
  EXPECT_EQ(Eval(Predicate::kIsReal, {I(2)}), "true");
}

TEST(ArithmeticTest, NoNumbers_IsNoValue) {
  SymbolTable symbols;
  EXPECT_EQ(Eval(Function::kSum, {I(1), Term::Constant(symbols.Intern("a"))}), "none");
  EXPECT_EQ(Eval(Function::kSum, {I(1), Term::Var(0)}), "none");
  EXPECT_EQ(Eval(Function::kSum, {I(1)}), "none");
  EXPECT_EQ(Eval(Predicate::kLess, {I(1)}), "none");
}

TEST(ArithmeticTest, Find_KnowsNameAndArity) {
  SymbolTable symbols;
  const Arithmetic arithmetic(symbols);
  EXPECT_EQ(arithmetic.FindPredicate(symbols.Intern("$lesseq"), 2), Predicate::kLessEq);
  EXPECT_EQ(arithmetic.FindPredicate(symbols.Intern("$lesseq"), 1), std::nullopt);
  EXPECT_EQ(arithmetic.FindPredicate(symbols.Intern("less"), 2), std::nullopt);
  EXPECT_EQ(arithmetic.FindFunction(symbols.Intern("$uminus"), 1), Function::kUminus);
  EXPECT_EQ(arithmetic.FindFunction(symbols.Intern("$max"), 2), Function::kMax);
}

TEST(ArithmeticTest, Normalize_EvaluatesInnermostFirst) {
  SymbolTable symbols;
  const Arithmetic arithmetic(symbols);
  const auto apply = [&](std::string_view name, std::vector<Term> arguments) {
    return Term::Compound(symbols.Intern(name), std::move(arguments));
  };
  const Term term = apply("f", {apply("$sum", {I(1), apply("$product", {I(2), I(3)})}),
                                Term::Constant(symbols.Intern("a"))});
  EXPECT_EQ(ToString(arithmetic.Normalize(term).value()), "f(7, a)");
  EXPECT_EQ(arithmetic.Normalize(apply("f", {apply("$quotient", {I(1), I(0)})})), std::nullopt);
  EXPECT_EQ(arithmetic.Normalize(apply("$sum", {I(1), apply("f", {I(1)})})), std::nullopt);
}

TEST(ArithmeticTest, Normalize_DeepTerm_DoesNotRecurse) {
  SymbolTable symbols;
  const Arithmetic arithmetic(symbols);
  const Symbol sum = symbols.Intern("$sum");
  Term term = I(0);
  for (int i = 0; i < 200'000; ++i) term = Term::Compound(sum, {term, I(1)});
  EXPECT_EQ(arithmetic.Normalize(term), I(200'000));
}

}  // namespace
}  // namespace latchwork::logic
