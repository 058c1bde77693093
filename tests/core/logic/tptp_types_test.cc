// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/tptp.h"

namespace latchwork::logic::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class TptpTypesTest : public ::testing::Test {
 protected:
  TptpFile Read(std::string_view text) { return ReadTptp(text, "t.p", symbols_); }

  /// What the formulas say, and the names of those that the text does not have.
  std::vector<std::string> Formulas(std::string_view text) {
    const TptpFile file = Read(text);
    EXPECT_THAT(file.diagnostics, IsEmpty()) << Format(file.diagnostics);
    std::vector<std::string> formulas;
    for (const AnnotatedFormula& each : file.formulas) {
      formulas.push_back(each.name + ": " + ToString(each.formula, each.variable_names));
    }
    return formulas;
  }

  SymbolTable symbols_;
};

struct Fault {
  std::string_view text;
  std::uint32_t line = 0;
  std::string_view message;
  std::string_view hint;
};

class TptpTypeFaultTest : public ::testing::TestWithParam<Fault> {};

TEST_P(TptpTypeFaultTest, IsReportedWithItsLine) {
  const Fault& fault = GetParam();
  SymbolTable symbols;
  const TptpFile file = ReadTptp(fault.text, "t.p", symbols);
  ASSERT_THAT(file.diagnostics, SizeIs(1)) << Format(file.diagnostics);
  EXPECT_EQ(file.diagnostics[0].place.line, fault.line);
  EXPECT_THAT(file.diagnostics[0].message, HasSubstr(fault.message));
  EXPECT_THAT(file.diagnostics[0].hint, HasSubstr(fault.hint));
}

INSTANTIATE_TEST_SUITE_P(
    All, TptpTypeFaultTest,
    ::testing::Values(
        Fault{"tff(t, type, p: ($int * $i) > $o).\ntff(a, axiom, p(a, 3)).", 2,
              "argument 2 of 'p' is $i, but '3' is $int", "'p' is declared in line 1"},
        Fault{"tff(a, axiom, p(1)).\ntff(b, axiom, p(1.5)).", 2,
              "argument 1 of 'p' is $int, but '1.5' is $real", "first used in line 1"},
        Fault{"tff(a, axiom, p(1.5)).\ntff(b, axiom, p(1)).", 2, "but '1' is $int",
              "reals are written as 1.0"},
        Fault{"tff(t, type, f: $int > $int).\ntff(a, axiom, f(a) = 1.5).", 2,
              "'f(a)' is $int, and '1.5', which it is equated with, is $real", "one type"},
        Fault{"tff(a, axiom, $less(1, 1.5)).", 1, "numbers of one type, but '1.5' is $real",
              "write 1.0"},
        Fault{"tff(t, type, a: $i).\ntff(a, axiom, ![X: $int]: $less(X, $sum(a, 1))).", 2,
              "'$sum' are numbers of one type, but 'a' is $i", ""},
        Fault{"tff(a, axiom, ![X: $int]: (p(X) => q(X))).\ntff(b, axiom, ![X: $real]: ~ q(X)).", 2,
              "argument 1 of 'q' is $int, but 'X' is $real", "first used in line 1"},
        Fault{"tff(t, type, p: $i > $o).\ntff(a, axiom, p(a, b)).", 2,
              "declared as a predicate of 1 argument, and used as a predicate of 2 arguments",
              "line 1"},
        Fault{"tff(t, type, p: $i > $o).\ntff(a, axiom, q(p(a))).", 2,
              "and used as a function of 1 argument", "line 1"},
        Fault{"tff(t, type, p: $i > $o).\ntff(u, type, p: $int > $o).\ntff(a, axiom, p(b)).", 2,
              "declared with two types", "line 1"},
        Fault{"tff(t, type, p: $o > $o).\ntff(a, axiom, q).", 1, "no argument", "$o"},
        Fault{"tff(t, type, p: ($i * $int)).\ntff(a, axiom, q).", 1, "expected '>'",
              "($i * $i) > $o"},
        Fault{"tff(t, type, p $i > $o).\ntff(a, axiom, q).", 1, "expected ':'", "p: $i > $o"},
        Fault{"tff(t, type, p: $rat > $o).\ntff(a, axiom, q).", 1, "found '$rat'", "not supported"},
        Fault{"tff(t, type, (p: ($i > $o)).\ntff(a, axiom, q).", 1, "or ')', found '.'", ""}));

TEST_F(TptpTypesTest, FaultsOfAllFormulas_ComeAtOnce) {
  EXPECT_THAT(Read("tff(a, axiom, p(1)). tff(b, axiom, p(1.5)). tff(c, axiom, p(b)).\n"
                   "tff(d, axiom, ![X: $real]: p(X)).")
                  .diagnostics,
              SizeIs(2));
}

TEST_F(TptpTypesTest, Declarations_MayStandInParenthesesAndBehindTheirUse) {
  EXPECT_THAT(Formulas("tff(a, axiom, p(f(1), c)). tff(t, type, (f: ($int > $i))).\n"
                       "tff(u, type, p: (($i * $i) > $o)). tff(v, type, c: $i, file('a.p', c))."),
              ElementsAre("a: p(f(1), c)"));
}

TEST_F(TptpTypesTest, UntypedLanguages_AreNotChecked) {
  EXPECT_THAT(Formulas("fof(a, axiom, p(1)). fof(b, axiom, p(1.5)). cnf(c, axiom, p(a) | X = 1).\n"
                       "tff(d, axiom, q(1))."),
              SizeIs(4));
}

TEST_F(TptpTypesTest, TypesThatChangeNothing_AreLeftOut) {
  EXPECT_THAT(Formulas("tff(a, axiom, ![X: $int]: ($less(X, 3) => p(X)))."),
              ElementsAre("a: ! [X] : ($less(X, 3) => p(X))"));
  EXPECT_THAT(Formulas("tff(a, axiom, ![X: $i]: X = a)."), ElementsAre("a: ! [X] : X = a"));
  EXPECT_THAT(Formulas("tff(a, axiom, ![X: $i, Y: $i]: ((age(X, 3) & X = Y) => age(Y, 3)))."
                       "tff(b, conjecture, ?[X: $i]: X = a)."),
              ElementsAre("a: ! [X, Y] : ((age(X, 3) & X = Y) => age(Y, 3))", "b: ? [X] : X = a"));
  EXPECT_THAT(Formulas("tff(a, axiom, ![X: $int, Y: $real]: p(X, Y))."),
              ElementsAre("a: ! [X, Y] : p(X, Y)"));
}

TEST_F(TptpTypesTest, IntegersBesideReals_AreComputedWithAsIntegers) {
  EXPECT_THAT(Formulas("tff(a, axiom, ![X: $int]: ~ ($less(0, X) & $less(X, 1))).\n"
                       "tff(b, axiom, ?[X: $real, Y: $int]: ($less(0.5, X) & p(X, $sum(Y, 1))))."),
              ElementsAre("a: ! [X] : ($is_int(X) => ~ ($less(0, X) & $less(X, 1)))",
                          "b: ? [X, Y] : ($is_int(Y) & ($less(0.5, X) & p(X, $sum(Y, 1))))"));
}

TEST_F(TptpTypesTest, IndividualsBesideNumbers_AreEquatedAsIndividuals) {
  EXPECT_THAT(
      Formulas("tff(a_type, type, a: $i). tff(n, axiom, ![X: $i]: X = a).\n"
               "tff(m, axiom, ![Y]: q(f(Y), Y, 3))."),
      ElementsAre("n: ! [X] : ('is an individual'(X) => X = a)",
                  "m: ! [Y] : ('is an individual'(Y) => q(f(Y), Y, 3))",
                  "individuals: ? [X0] : 'is an individual'(X0)", "a_type: 'is an individual'(a)",
                  "type_of_f: ! [X0] : 'is an individual'(f(X0))"));
}

}  // namespace
}  // namespace latchwork::logic::testing
