// SPDX-License-Identifier: BSD-3-Clause
//
// Why the prover made a default, what retracted it, and what clauses lack.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "latchwork/sdk/explanation.h"
#include "tests/reasoners/pttp/agent_mind.h"
#include "tests/reasoners/pttp/reflex_setting.h"

namespace latchwork::pttp {
namespace {

class ReasonsTest : public ::testing::Test {
 protected:
  ReasonsTest() : mind_(kReflex) { PrepareReflex(mind_); }

  std::string WhyNot(const char* pattern) {
    const auto explanation = mind_.reasoner.WhyNot(mind_.Atom(pattern));
    return explanation ? ToText(*explanation) : "none";
  }
  std::string WhyAssumed() {
    const auto explanation = mind_.reasoner.ExplainAssumption(0);
    return explanation ? ToText(*explanation) : "none";
  }

  AgentMind mind_;
};

TEST_F(ReasonsTest, DefaultsAreMadeForWhatClausesLack) {
  EXPECT_EQ(WhyAssumed(), "none");
  mind_.Latch(1, {"object(box)", "distance(box, 0.75)"});
  mind_.Decide();
  EXPECT_EQ(WhyAssumed(),
            "nothing concludes halt_robot:\n"
            "  'ahead' has 3 of 4 premises and lacks $less(0.75, 0.5)\n"
            "  'touched' has 0 of 1 premises and lacks bumper\n");
}

TEST_F(ReasonsTest, RetractionsNameTheFactsAndPortsBehindThem) {
  mind_.Latch(1, {"object(box)", "distance(box, 0.25)"});
  mind_.Decide();
  EXPECT_THAT(WhyAssumed(), ::testing::StartsWith("halt_robot holds:\n"));
  EXPECT_THAT(WhyAssumed(), ::testing::HasSubstr("  distance(box, 0.25)  [latch latch1]\n"));
  EXPECT_EQ(WhyNot("fwd(V)"),
            "nothing concludes fwd(X0):\n"
            "  'go' has 1 of 2 premises and lacks ~ halt_robot\n");
}

TEST_F(ReasonsTest, AskingDoesNotChangeWhatIsDecided) {
  mind_.Latch(1, {"object(box)", "distance(box, 0.75)"});
  mind_.Decide();
  const auto before = mind_.Conclusions();
  const auto assumptions = mind_.decision.assumptions;
  EXPECT_THAT(WhyNot("fwd(V)"), ::testing::HasSubstr("speed(0.3)  [latch latch0]"));
  WhyAssumed();
  mind_.Decide();
  EXPECT_EQ(mind_.Conclusions(), before);
  mind_.Latch(1, {"bumper"});
  mind_.Decide();
  EXPECT_TRUE(mind_.Conclusions().empty());
  mind_.Latch(1, {});
  mind_.Decide();
  EXPECT_EQ(mind_.Conclusions(), before);
  EXPECT_EQ(mind_.decision.assumptions, assumptions);
}

TEST(ReasonsOfPatternsTest, RepeatedVariablesAndComputedArguments) {
  AgentMind mind(
      "fof(near, axiom, ! [X, Y] : (seen(X, Y) => near(X, Y))).\n"
      "fof(next, axiom, ! [X] : (in(X) => out($sum(X, 1)))).\n"
      "fof(of, axiom, ! [X] : (in(X) => near(f(X), X))).\n");
  mind.Input("seen", 2);
  mind.Input("in", 1);
  mind.Goal("near(X, Y)");
  mind.Goal("out(X)");
  mind.Load();
  mind.Latch(0, {"seen(b, c)", "in(3)"});
  mind.Decide();
  const auto why_not = [&](const char* pattern) {
    return ToText(*mind.reasoner.WhyNot(mind.Atom(pattern)));
  };
  EXPECT_EQ(why_not("near(X, X)"),
            "nothing concludes near(X0, X0):\n"
            "  'near' has 0 of 1 premises and lacks seen(X, X)\n");
  EXPECT_THAT(why_not("near(X, c)"), ::testing::StartsWith("near(X0, c) holds:\n"));
  EXPECT_EQ(why_not("out(7)"),
            "nothing concludes out(7):\n"
            "  'next' has 1 of 2 premises and lacks $sum(3, 1) = 7\n");
  EXPECT_EQ(why_not("far(b)"), "nothing concludes far(b), and no clause could\n");
}

TEST_F(ReasonsTest, WhatTheBudgetEndedIsNotSaidToLack) {
  mind_.budget.inferences = 2;
  mind_.Latch(1, {"object(box)", "distance(box, 0.75)"});
  mind_.Decide();
  EXPECT_THAT(WhyNot("halt_robot"), ::testing::HasSubstr("lacks more inferences to say what\n"));
  EXPECT_THAT(WhyNot("halt_robot"), ::testing::Not(::testing::HasSubstr("lacks $less")));
}

TEST(ReasonsWithinBoundsTest, WhatOnlyLacksDepthSaysSo) {
  AgentMind mind(
      "fof(zero, axiom, n(z)).\n"
      "fof(next, axiom, ! [X] : (n(X) => n(s(X)))).\n"
      "fof(no, axiom, ! [X] : ((asked(X) & ~ n(X)) => not_a_number(X))).\n");
  mind.Input("asked", 1);
  mind.Minimize("n", 1, 3);
  mind.Goal("not_a_number(X)");
  mind.Load();
  mind.Latch(0, {"asked(s(s(s(s(z)))))"});
  mind.Decide();
  ASSERT_EQ(mind.decision.assumptions.size(), 1U);
  ASSERT_EQ(mind.decision.assumptions[0].state, sdk::Assumption::State::kMadeByBound);
  EXPECT_EQ(ToText(*mind.reasoner.ExplainAssumption(0)),
            "nothing concludes n(s(s(s(s(z))))):\n"
            "  'next' has 1 of 1 premises and lacks a deeper search\n");
}

}  // namespace
}  // namespace latchwork::pttp
