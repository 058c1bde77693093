// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/formula.h"

#include <gtest/gtest.h>

namespace latchwork::logic {
namespace {

class FormulaTest : public testing::Test {
 protected:
  Formula Proposition(std::string_view name) { return Formula::Of(Atom(symbols_.Intern(name))); }

  SymbolTable symbols_;
};

TEST_F(FormulaTest, DefaultMade_IsTrue) {
  EXPECT_EQ(Formula().kind(), Formula::Kind::kTrue);
  EXPECT_TRUE(Formula().children().empty());
  EXPECT_TRUE(Formula().variables().empty());
}

TEST_F(FormulaTest, Parts_AreKept) {
  const Formula formula = Formula::Exists({4}, Formula::Not(Proposition("p")));
  EXPECT_EQ(formula.kind(), Formula::Kind::kExists);
  EXPECT_EQ(formula.variables()[0], 4U);
  EXPECT_EQ(formula.children()[0].children()[0].atom().predicate().name(), "p");
}

TEST_F(FormulaTest, OtherChildren_BelowTheSameConnectiveOrQuantifier) {
  const Formula p = Proposition("p");
  const Formula q = Proposition("q");
  EXPECT_EQ(ToString(Formula::Implies(p, p).With({q, p})), "q => p");
  EXPECT_EQ(ToString(Formula::Not(p).With({q})), "~ q");
  const Formula bound = Formula::Forall({0, 3}, p).With({q});
  EXPECT_EQ(bound.kind(), Formula::Kind::kForall);
  EXPECT_EQ(bound.variables()[1], 3U);
  EXPECT_EQ(ToString(bound.children()[0]), "q");
  EXPECT_EQ(ToString(p.With({})), "p");
}

TEST_F(FormulaTest, Copies_ShareAndSurvive) {
  Formula copy;
  {
    const Formula original = Formula::And({Proposition("p"), Proposition("q")});
    copy = original;
  }
  const Formula inner = copy.children()[1];
  copy = inner;
  EXPECT_EQ(ToString(copy), "q");
}

TEST_F(FormulaTest, ToString_SetsParenthesesWhereTptpNeedsThem) {
  const Formula p = Proposition("p");
  const Formula q = Proposition("q");
  EXPECT_EQ(ToString(Formula::Not(Formula::Or({p, q}))), "~ (p | q)");
  EXPECT_EQ(ToString(Formula::And({Formula::And({p, q}), p})), "(p & q) & p");
  EXPECT_EQ(ToString(Formula::Implies(Formula::Not(p), Formula::Equivalent(p, q))),
            "~ p => (p <=> q)");
  EXPECT_EQ(ToString(Formula::Forall({0, 1}, Formula::And({p, q}))), "! [X0, X1] : (p & q)");
  EXPECT_EQ(ToString(Formula::And({Formula::Exists({0}, p), Formula::False()})),
            "? [X0] : p & $false");
}

TEST_F(FormulaTest, DeepFormula_NothingRecurses) {
  Formula formula = Proposition("p");
  constexpr std::size_t kDeep = 1'000'000;
  for (std::size_t i = 0; i < kDeep; ++i) formula = Formula::Not(std::move(formula));
  const Formula copy = formula;
  EXPECT_EQ(ToString(copy).size(), kDeep * 2 + 1);
}

}  // namespace
}  // namespace latchwork::logic
