// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/strategies/prover.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "latchwork/logic/tptp.h"

namespace latchwork::pttp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ProverResult Try(std::string_view text, std::uint64_t inferences = 300'000) {
  logic::SymbolTable symbols;
  const auto file = logic::ReadTptp(text, "test", symbols);
  EXPECT_THAT(file.diagnostics, IsEmpty()) << Format(file.diagnostics);
  ProverOptions options;
  options.budget.inferences = inferences;
  options.budget.depth = 1000;
  options.proof = true;
  return Prove(file.formulas, symbols, "test", options);
}

/// Problems of Pelletier (1986), by number.
struct Problem {
  int number;
  std::string_view text;
};

class PelletierTest : public ::testing::TestWithParam<Problem> {};

TEST_P(PelletierTest, IsProved) {
  const ProverResult result = Try(GetParam().text);
  EXPECT_EQ(Name(result.status), "Theorem") << GetParam().number;
  ASSERT_FALSE(result.proof.empty());
  EXPECT_THAT(result.proof.back(), HasSubstr("$false"));
}

constexpr Problem kProblems[] = {
    {1, "fof(c, conjecture, ((p => q) <=> (~ q => ~ p)))."},
    {2, "fof(c, conjecture, (~ ~ p <=> p))."},
    {3, "fof(c, conjecture, (~ (p => q) => (q => p)))."},
    {4, "fof(c, conjecture, ((~ p => q) <=> (~ q => p)))."},
    {5, "fof(c, conjecture, (((p | q) => (p | r)) => (p | (q => r))))."},
    {6, "fof(c, conjecture, (p | ~ p))."},
    {7, "fof(c, conjecture, (p | ~ ~ ~ p))."},
    {8, "fof(c, conjecture, (((p => q) => p) => p))."},
    {9, "fof(c, conjecture, (((p | q) & (~ p | q) & (p | ~ q)) => ~ (~ p | ~ q)))."},
    {10,
     "fof(a, axiom, (q => r)). fof(b, axiom, (r => (p & q))). fof(d, axiom, (p => (q | r))). "
     "fof(c, conjecture, (p <=> q))."},
    {11, "fof(c, conjecture, (p <=> p))."},
    {12, "fof(c, conjecture, (((p <=> q) <=> r) <=> (p <=> (q <=> r))))."},
    {13, "fof(c, conjecture, ((p | (q & r)) <=> ((p | q) & (p | r))))."},
    {14, "fof(c, conjecture, ((p <=> q) <=> ((q | ~ p) & (~ q | p))))."},
    {15, "fof(c, conjecture, ((p => q) <=> (~ p | q)))."},
    {16, "fof(c, conjecture, ((p => q) | (q => p)))."},
    {17, "fof(c, conjecture, (((p & (q => r)) => s) <=> ((~ p | q | s) & (~ p | ~ r | s))))."},
    {18, "fof(c, conjecture, ?[Y] : ![X] : (f(Y) => f(X)))."},
    {19, "fof(c, conjecture, ?[X] : ![Y, Z] : ((p(Y) => q(Z)) => (p(X) => q(X))))."},
    {20,
     "fof(c, conjecture, (![X, Y] : ?[Z] : ![W] : ((p(X) & q(Y)) => (r(Z) & s(W))) => "
     "(?[X, Y] : (p(X) & q(Y)) => ?[Z] : r(Z))))."},
    {21,
     "fof(a, axiom, ?[X] : (p => f(X))). fof(b, axiom, ?[X] : (f(X) => p)). "
     "fof(c, conjecture, ?[X] : (p <=> f(X)))."},
    {24,
     "fof(a, axiom, ~ ?[X] : (s(X) & q(X))). fof(b, axiom, ![X] : (p(X) => (q(X) | r(X)))). "
     "fof(d, axiom, (~ ?[X] : p(X) => ?[Y] : q(Y))). fof(e, axiom, ![X] : ((q(X) | r(X)) => "
     "s(X))). "
     "fof(c, conjecture, ?[X] : (p(X) & r(X)))."},
    {39, "fof(c, conjecture, ~ ?[X] : ![Y] : (f(Y, X) <=> ~ f(Y, Y)))."},
    {44,
     "fof(a, axiom, ![X] : (f(X) => (?[Y] : (g(Y) & h(X, Y)) & ?[Y] : (g(Y) & ~ h(X, Y))))). "
     "fof(b, axiom, ?[X] : (j(X) & ![Y] : (g(Y) => h(X, Y)))). "
     "fof(c, conjecture, ?[X] : (j(X) & ~ f(X)))."},
    {48,
     "fof(a, axiom, (a = b | c = d)). fof(b, axiom, (a = c | b = d)). "
     "fof(c, conjecture, (a = d | b = c))."},
};

INSTANTIATE_TEST_SUITE_P(Problems, PelletierTest, ::testing::ValuesIn(kProblems),
                         [](const auto& problem) { return std::to_string(problem.param.number); });

TEST(ProverTest, SatisfiableWhenExhausted) {
  EXPECT_EQ(Try("cnf(a, axiom, p(a)). cnf(b, axiom, ~ p(X) | q(X)).").status, Szs::kSatisfiable);
  EXPECT_EQ(Try("fof(a, axiom, p(a)). fof(c, conjecture, q(a)).").status, Szs::kCounterSatisfiable);
}

TEST(ProverTest, ContradictionWithoutConjectureIsUnsatisfiable) {
  EXPECT_EQ(Try("cnf(a, axiom, p). cnf(b, axiom, ~ p).").status, Szs::kUnsatisfiable);
  EXPECT_EQ(Try("cnf(a, axiom, $false).").status, Szs::kUnsatisfiable);
}

TEST(ProverTest, ContradictoryAxiomsProveAnything) {
  EXPECT_EQ(Try("fof(a, axiom, p). fof(b, axiom, ~ p). fof(c, conjecture, q).").status,
            Szs::kTheorem);
}

TEST(ProverTest, NumbersAreNeverCalledSatisfiable) {
  EXPECT_NE(Try("fof(a, axiom, 1 = c).").status, Szs::kSatisfiable);
  EXPECT_NE(Try("fof(a, axiom, \"x\" = c).").status, Szs::kSatisfiable);
}

TEST(ProverTest, DistinctObjectsAreUnequal) {
  EXPECT_EQ(Try("fof(a, axiom, \"x\" = \"y\").").status, Szs::kUnsatisfiable);
}

TEST(ProverTest, EndlessSearchRunsOutOfInferences) {
  const auto result =
      Try("cnf(a, axiom, p(X) | ~ p(f(X))). cnf(z, axiom, p(b)). cnf(b, axiom, ~ p(a)).", 500);
  EXPECT_EQ(result.status, Szs::kResourceOut);
}

TEST(ProverTest, AnswersNameTheWitness) {
  const auto result = Try("fof(a, axiom, p(a, f(b))). fof(c, conjecture, ?[X, Y] : p(X, Y)).");
  EXPECT_THAT(result.answers, ElementsAre(ElementsAre("a", "f(b)")));
}

TEST(ProverTest, DisjunctiveAnswerNamesBoth) {
  const auto result = Try("fof(a, axiom, (p(a) | p(b))). fof(c, conjecture, ?[X] : p(X)).");
  EXPECT_EQ(result.answers.size(), 2U);
}

TEST(ProverTest, DeepTermsNeedNoStack) {
  std::string term = "a";
  for (int i = 0; i < 20'000; ++i) term = "f(" + term + ")";
  const auto result = Try("cnf(a, axiom, p(" + term + ")). cnf(b, axiom, ~ p(" + term + ")).");
  EXPECT_EQ(result.status, Szs::kUnsatisfiable);
}

TEST(ProverTest, ClauseWithHundredLiteralsIsUsed) {
  std::string text = "cnf(long, axiom, goal";
  for (int i = 0; i < 100; ++i) text += " | ~ p" + std::to_string(i);
  text += ").\ncnf(g, axiom, ~ goal).\n";
  for (int i = 0; i < 100; ++i) text += "cnf(f, axiom, p" + std::to_string(i) + ").\n";
  EXPECT_EQ(Try(text).status, Szs::kUnsatisfiable);
}

}  // namespace
}  // namespace latchwork::pttp
