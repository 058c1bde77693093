// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/term.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace latchwork::logic {
namespace {

constexpr int kDeep = 1'000'000;

class TermTest : public testing::Test {
 protected:
  Term Constant(std::string_view name) { return Term::Constant(symbols_.Intern(name)); }
  Term Apply(std::string_view name, std::vector<Term> arguments) {
    return Term::Compound(symbols_.Intern(name), std::move(arguments));
  }
  Term Nested(Term inside, int depth) {
    const Symbol f = symbols_.Intern("f");
    for (int i = 0; i < depth; ++i) inside = Term::Compound(f, {std::move(inside)});
    return inside;
  }

  SymbolTable symbols_;
};

TEST_F(TermTest, Accessors_GiveWhatWasMade) {
  EXPECT_EQ(Term::Var(3).variable(), 3U);
  EXPECT_EQ(Term::Integer(-4).integer(), -4);
  EXPECT_EQ(Term::Real(2.5).number(), 2.5);
  EXPECT_EQ(Term::Integer(2).number(), 2.0);
  EXPECT_EQ(Constant("a").symbol().name(), "a");
  const Term term = Apply("g", {Constant("a"), Term::Var(0)});
  EXPECT_EQ(term.symbol().name(), "g");
  ASSERT_EQ(term.arguments().size(), 2U);
  EXPECT_EQ(term.arguments()[1], Term::Var(0));
}

TEST_F(TermTest, Groundness_SeesVariablesInside) {
  EXPECT_TRUE(Apply("f", {Apply("f", {Constant("a")})}).is_ground());
  EXPECT_FALSE(Apply("f", {Apply("f", {Term::Var(0)})}).is_ground());
  EXPECT_FALSE(Term::Var(0).is_ground());
}

TEST_F(TermTest, Equality_IsStructural) {
  EXPECT_EQ(Apply("f", {Constant("a")}), Apply("f", {Constant("a")}));
  EXPECT_NE(Apply("f", {Constant("a")}), Apply("f", {Constant("b")}));
  EXPECT_NE(Apply("f", {Constant("a")}), Apply("f", {Constant("a"), Constant("a")}));
  EXPECT_NE(Term::Integer(1), Term::Real(1.0));
  EXPECT_EQ(Term::Real(-0.0), Term::Real(0.0));
}

TEST_F(TermTest, Order_FollowsKinds) {
  const std::vector<Term> ascending = {Term::Var(0),
                                       Term::Var(1),
                                       Term::Integer(-5),
                                       Term::Integer(7),
                                       Term::Real(-1),
                                       Term::Real(2),
                                       Constant("a"),
                                       Constant("b"),
                                       Apply("a", {Constant("z")}),
                                       Apply("b", {Constant("a")}),
                                       Apply("b", {Constant("c")}),
                                       Apply("b", {Constant("a"), Constant("a")})};
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    for (std::size_t j = 0; j < ascending.size(); ++j) {
      EXPECT_EQ(ascending[i] <=> ascending[j], i <=> j) << i << ' ' << j;
    }
  }
}

TEST_F(TermTest, Copies_ShareAndSurvive) {
  Term copy;
  {
    const Term original = Apply("f", {Apply("g", {Constant("a")})});
    copy = original;
  }
  EXPECT_EQ(ToString(copy), "f(g(a))");
  const Term inner = copy.arguments()[0];
  copy = inner;
  EXPECT_EQ(ToString(copy), "g(a)");
  copy = copy.arguments()[0];
  EXPECT_EQ(ToString(copy), "a");
}

TEST_F(TermTest, Move_LeavesNothingBehind) {
  Term from = Apply("f", {Constant("a")});
  const Term to = std::move(from);
  EXPECT_EQ(ToString(to), "f(a)");
  from = to;
  Term& self = from;
  self = std::move(from);
  EXPECT_EQ(from, to);
}

TEST_F(TermTest, ToString_Numbers_ReadBack) {
  EXPECT_EQ(ToString(Term::Integer(-12)), "-12");
  EXPECT_EQ(ToString(Term::Real(1.0)), "1.0");
  EXPECT_EQ(ToString(Term::Real(-0.0)), "-0.0");
  EXPECT_EQ(ToString(Term::Real(0.1)), "0.1");
  EXPECT_EQ(ToString(Term::Real(1e300)), "1e+300");
}

TEST_F(TermTest, ToString_Words_QuotesWhereNeeded) {
  EXPECT_EQ(ToString(Constant("aB_1")), "aB_1");
  EXPECT_EQ(ToString(Constant("$sum")), "$sum");
  EXPECT_EQ(ToString(Constant("Abc")), "'Abc'");
  EXPECT_EQ(ToString(Constant("it's \\")), "'it\\'s \\\\'");
  EXPECT_EQ(ToString(Term::Constant(symbols_.Intern("a \"b\"", SymbolKind::kDistinctObject))),
            "\"a \\\"b\\\"\"");
  EXPECT_EQ(QuoteWord("$"), "'$'");
  EXPECT_EQ(QuoteWord(""), "''");
}

TEST_F(TermTest, ToString_Variables_TakesNames) {
  const std::vector<std::string> names = {"Left", ""};
  const Term term = Apply("f", {Term::Var(0), Term::Var(1), Apply("g", {Term::Var(2)})});
  EXPECT_EQ(ToString(term, names), "f(Left, X1, g(X2))");
}

TEST_F(TermTest, DeepTerm_NothingRecurses) {
  const Term a = Nested(Constant("a"), kDeep);
  const Term b = Nested(Constant("b"), kDeep);
  EXPECT_LT(a, b);
  EXPECT_TRUE(a.is_ground());
  const std::string text = ToString(a);
  EXPECT_EQ(text.size(), std::size_t{kDeep} * 3 + 1);
  EXPECT_EQ(text.find('a'), std::size_t{kDeep} * 2);
}

TEST_F(TermTest, DeepOpenTerms_AreEqualAndNotGround) {
  const Term a = Nested(Term::Var(0), kDeep / 10);
  EXPECT_EQ(a, Nested(Term::Var(0), kDeep / 10));
  EXPECT_FALSE(a.is_ground());
}

TEST_F(TermTest, SharedTerm_ThreadsCopyAndDrop_Survives) {
  const Term shared = Nested(Constant("a"), 10);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&shared] {
      for (int n = 0; n < 1000; ++n) {
        Term copy = shared;
        const Term wrapped = copy.arguments()[0];
        copy = wrapped;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(shared, Nested(Constant("a"), 10));
}

}  // namespace
}  // namespace latchwork::logic
