// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/clausify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "latchwork/logic/tptp.h"
#include "tests/core/logic/finite_models.h"
#include "tests/core/logic/random_formula.h"

namespace latchwork::logic {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class ClausifyTest : public testing::Test {
 protected:
  std::vector<AnnotatedFormula> Read(const std::string& text) {
    TptpFile file = ReadTptp(text, "test.p", symbols_);
    EXPECT_THAT(Format(file.diagnostics), IsEmpty());
    return std::move(file.formulas);
  }

  std::vector<std::string> Clauses(const std::string& text) {
    std::vector<std::string> clauses;
    for (const Clause& clause : Clausify(Read(text), symbols_)) clauses.push_back(ToString(clause));
    return clauses;
  }

  std::vector<std::string> Fof(const std::string& formula) {
    return Clauses("fof(n, axiom, " + formula + ").");
  }

  SymbolTable symbols_;
};

TEST_F(ClausifyTest, Connectives_BecomeClauses) {
  EXPECT_THAT(Fof("a => b"), ElementsAre("~ a | b"));
  EXPECT_THAT(Fof("~ (a & (b | c))"), ElementsAre("~ a | ~ b", "~ a | ~ c"));
  EXPECT_THAT(Fof("a <=> b"), ElementsAre("~ a | b", "a | ~ b"));
  EXPECT_THAT(Fof("a <~> b"), ElementsAre("~ a | ~ b", "a | b"));
  EXPECT_THAT(Fof("~ (a => b)"), ElementsAre("a", "~ b"));
}

TEST_F(ClausifyTest, Constants_Vanish) {
  EXPECT_THAT(Fof("a | $true"), IsEmpty());
  EXPECT_THAT(Fof("a & $true"), ElementsAre("a"));
  EXPECT_THAT(Fof("a <=> $false"), ElementsAre("~ a"));
  EXPECT_THAT(Fof("$false"), ElementsAre("$false"));
  EXPECT_THAT(Fof("! [X] : ~ $false"), IsEmpty());
}

TEST_F(ClausifyTest, TautologiesAndRepetitions_Vanish) {
  EXPECT_THAT(Fof("a | b | ~ a"), IsEmpty());
  EXPECT_THAT(Fof("! [X] : (p(X) => X = X)"), IsEmpty());
  EXPECT_THAT(Fof("b | a | b"), ElementsAre("b | a"));
  EXPECT_THAT(Fof("! [X, Y] : (p(X) | ~ p(Y))"), ElementsAre("p(X) | ~ p(Y)"));
}

TEST_F(ClausifyTest, Existentials_DependOnWhatTheyMust) {
  EXPECT_THAT(Fof("? [X] : p(X)"), ElementsAre("p(sk_1)"));
  EXPECT_THAT(Fof("! [X] : ? [Y] : q(X, Y)"), ElementsAre("q(X, sk_2(X))"));
  EXPECT_THAT(Fof("! [X] : ? [Y] : (p(Y) & r(X))"), ElementsAre("p(sk_3)", "r(X)"));
  EXPECT_THAT(Fof("! [X] : (p(X) | ? [Y] : ! [Z] : q(Y, Z))"), ElementsAre("p(X) | q(sk_4, Z)"));
  EXPECT_THAT(Fof("! [U, V] : ? [X, Y] : (q(X, U) & q(X, Y) & q(Y, V))"),
              ElementsAre("q(sk_5(U, V), U)", "q(sk_5(U, V), sk_6(U, V))", "q(sk_6(U, V), V)"));
}

TEST_F(ClausifyTest, Variables_AreNumberedDenselyAndNamedApart) {
  const auto clauses =
      Clausify(Read("fof(n, axiom, ! [X, Y] : (r & p(Y) & (! [X] : q(X, Y) | p(X))))."), symbols_);
  ASSERT_THAT(clauses, SizeIs(3));
  EXPECT_THAT(clauses[0].variable_names, IsEmpty());
  EXPECT_THAT(clauses[1].variable_names, ElementsAre("Y"));
  EXPECT_EQ(clauses[1].literals[0].atom.argument(0), Term::Var(0));
  EXPECT_EQ(ToString(clauses[2]), "q(X, Y) | p(X_2)");
}

TEST_F(ClausifyTest, LiteralOrder_IsKept) {
  EXPECT_THAT(Fof("! [X, Y] : ((p(X) & r & p(Y)) => (q(X, Y) | s))"),
              ElementsAre("~ p(X) | ~ r | ~ p(Y) | q(X, Y) | s"));
  EXPECT_THAT(Clauses("cnf(n, axiom, s | p(Z) | ~ p(A))."), ElementsAre("s | p(Z) | ~ p(A)"));
}

TEST_F(ClausifyTest, Conjecture_IsNegated) {
  const auto clauses = Clausify(
      Read("fof(a, axiom, p). fof(b, conjecture, ! [X] : q(X)). fof(c, axiom, r)."), symbols_);
  ASSERT_THAT(clauses, SizeIs(3));
  EXPECT_EQ(ToString(clauses[1]), "~ q(sk_1)");
  EXPECT_EQ(clauses[1].role, Role::kNegatedConjecture);
  EXPECT_EQ(clauses[1].name, "b");
  EXPECT_EQ(clauses[1].place.line, 1U);
  EXPECT_EQ(clauses[2].name, "c");
}

TEST_F(ClausifyTest, SeveralConjectures_AreNegatedTogether) {
  EXPECT_THAT(Clauses("fof(a, conjecture, p). fof(b, axiom, r). fof(c, conjecture, q)."),
              ElementsAre("def_1 | def_2", "~ def_1 | ~ p", "~ def_2 | ~ q", "r"));
}

TEST_F(ClausifyTest, WideDistribution_IsNamed) {
  std::string formula = "(a0 & b0)";
  for (int i = 1; i < 20; ++i) {
    formula += " | (a" + std::to_string(i) + " & b" + std::to_string(i) + ")";
  }
  EXPECT_THAT(Fof(formula), SizeIs(testing::Le(60U)));
}

TEST_F(ClausifyTest, EquivalenceChain_IsNamed) {
  std::string formula = "a0";
  for (int i = 1; i < 40; ++i) formula = "(" + formula + " <=> a" + std::to_string(i) + ")";
  EXPECT_THAT(Fof(formula), SizeIs(testing::Le(400U)));
}

TEST_F(ClausifyTest, ManyConclusions_AreNotNamed) {
  std::string formula = "! [X] : ((p(X) & q(X)) => (c0(X)";
  for (int i = 1; i < 100; ++i) formula += " & c" + std::to_string(i) + "(X)";
  const auto clauses = Fof(formula + "))");
  ASSERT_THAT(clauses, SizeIs(100));
  EXPECT_EQ(clauses[99], "~ p(X) | ~ q(X) | c99(X)");
}

TEST_F(ClausifyTest, DeepFormulas_DoNotRecurse) {
  constexpr int kDeep = 20'000;
  std::string alternating;
  std::string implications;
  for (int i = 0; i < kDeep; ++i) {
    alternating += i % 2 == 0 ? "(a & " : "(b | ";
    implications += "(p => ";
  }
  EXPECT_THAT(Fof(alternating + "c" + std::string(kDeep, ')')), SizeIs(testing::Gt(kDeep / 4)));
  EXPECT_THAT(Fof(implications + "q" + std::string(kDeep, ')')), ElementsAre("~ p | q"));
}

TEST_F(ClausifyTest, DeepQuantifiers_StayWithinTheLimit) {
  constexpr int kDeep = 10'000;
  std::string text = "fof(n, axiom, ";
  for (int i = 0; i < kDeep; ++i) text += "! [X] : ? [Y] : (q(X, Y) & ";
  text += "r" + std::string(kDeep, ')') + ").";
  const auto formulas = Read(text);
  EXPECT_THAT(Clausify(formulas, symbols_), SizeIs(kDeep + 1));
  ClausifyOptions options;
  options.max_symbols = 1000;
  Diagnostics diagnostics;
  EXPECT_THAT(Clausify(formulas, symbols_, options, &diagnostics), IsEmpty());
  ASSERT_THAT(diagnostics, SizeIs(1));
  EXPECT_EQ(diagnostics[0].place.line, 1U);
  EXPECT_THROW(Clausify(formulas, symbols_, options), std::length_error);
}

class ClausifyModelsTest : public testing::TestWithParam<std::size_t> {};

TEST_P(ClausifyModelsTest, RandomFormulas_KeepTheirModels) {
  ClausifyOptions options;
  options.distribution_limit = GetParam();
  int with_model = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SymbolTable symbols;
    RandomFormula random(symbols, seed * 7919);
    AnnotatedFormula formula = random.Next(4);
    formula.role = seed % 3 == 0 ? Role::kConjecture : Role::kAxiom;
    const bool is_negated = formula.role == Role::kConjecture;
    const Formula claim = is_negated ? Formula::Not(formula.formula) : formula.formula;
    const auto clauses = Clausify({formula}, symbols, options);
    for (const std::size_t size : {1U, 2U}) {
      const bool expected = HasModel(claim, size);
      with_model += expected ? 1 : 0;
      ASSERT_EQ(HasModel(clauses, size), expected)
          << "seed " << seed << ", size " << size << ": " << ToString(claim);
    }
  }
  EXPECT_GT(with_model, 100);
  EXPECT_LT(with_model, 780);
}

INSTANTIATE_TEST_SUITE_P(DistributionLimits, ClausifyModelsTest, testing::Values(1, 4, 24));

}  // namespace
}  // namespace latchwork::logic
