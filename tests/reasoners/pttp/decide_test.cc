// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(DecideTest, ConcludesFromLatchFact) {
  AgentMind mind("cnf(rule, axiom, turn(A) | ~ heading(A)).");
  mind.Input("heading", 1);
  mind.Goal("turn(A)");
  mind.Load();
  mind.Latch(0, {"heading(0.5)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("turn(0.5)"));
}

TEST(DecideTest, EmptyLatchRefutes) {
  AgentMind mind("cnf(rule, axiom, turn(A) | ~ heading(A)).");
  mind.Input("heading", 1);
  mind.Goal("turn(A)");
  mind.Load();
  mind.Latch(0, {});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
  EXPECT_THAT(mind.Conclusions(), IsEmpty());
}

TEST(DecideTest, LatchIsReplacedNotAccumulated) {
  AgentMind mind("cnf(rule, axiom, turn(A) | ~ heading(A)).");
  mind.Input("heading", 1);
  mind.Goal("turn(A)", sdk::Goal::Answers::kAll);
  mind.Load();
  mind.Latch(0, {"heading(1)", "heading(2)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("turn(1)", "turn(2)"));
  mind.Latch(0, {"heading(3)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("turn(3)"));
}

TEST(DecideTest, ArithmeticWaitsUntilGround) {
  AgentMind mind(
      "cnf(near, axiom, near(N, E) | ~ $less(D, 2.0) | E != $sum(D, 1.0) | ~ reading(N, D)).");
  mind.Input("reading", 2);
  mind.Goal("near(N, E)", sdk::Goal::Answers::kAll);
  mind.Load();
  mind.Latch(0, {"reading(0, 1.5)", "reading(1, 2.5)", "reading(2, 0.25)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("near(0, 2.5)", "near(2, 1.25)"));
}

TEST(DecideTest, ArithmeticInHeadIsComputed) {
  AgentMind mind("cnf(next, axiom, next($sum(X, 1)) | ~ now(X)).");
  mind.Input("now", 1);
  mind.Goal("next(X)");
  mind.Load();
  mind.Latch(0, {"now(41)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("next(42)"));
}

TEST(DecideTest, NeverGroundArithmeticIsUnknown) {
  AgentMind mind("cnf(odd, axiom, p | ~ $less(X, 2)).");
  mind.Goal("p");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
  EXPECT_THAT(mind.decision.message, HasSubstr("instantiation"));
}

TEST(DecideTest, UnchangedLatchesKeepTheDecision) {
  AgentMind mind("cnf(rule, axiom, turn(A) | ~ heading(A)).");
  mind.Input("heading", 1);
  mind.Goal("turn(A)");
  mind.Load();
  mind.Latch(0, {"heading(1)"});
  EXPECT_GT(mind.Decide().statistics.inferences, 0U);
  EXPECT_EQ(mind.Decide().statistics.inferences, 0U);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("turn(1)"));
}

TEST(DecideTest, NonHornTheoryNeedsReduction) {
  AgentMind mind(
      "cnf(a, axiom, p | q). cnf(b, axiom, p | ~ q). cnf(c, axiom, ~ p | q). cnf(d, axiom, r | ~ p "
      "| ~ q).");
  mind.Goal("r");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
}

TEST(DecideTest, DisjunctionGivesNoDefiniteAnswer) {
  AgentMind mind("cnf(a, axiom, p(a) | p(b)).");
  mind.Goal("p(X)");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
}

TEST(DecideTest, DepthBoundLeavesUnknown) {
  AgentMind mind(
      "cnf(z, axiom, n(z)). cnf(s, axiom, n(s(X)) | ~ n(X)). cnf(g, axiom, goal | ~ "
      "n(s(s(s(s(z)))))).");
  mind.Goal("goal");
  mind.Load();
  mind.budget.depth = 3;
  EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kDepth);
  mind.budget.depth = 9;
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
}

TEST(DecideTest, InferenceBudgetLeavesUnknown) {
  AgentMind mind(
      "cnf(b, axiom, n(a)). cnf(s, axiom, n(X) | ~ n(s(X))). cnf(g, axiom, goal | ~ n(z)).");
  mind.Goal("goal");
  mind.Load();
  mind.budget.inferences = 10;
  EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kInferences);
}

TEST(DecideTest, CancelledDecisionIsUnknown) {
  AgentMind mind(
      "cnf(b, axiom, n(a)). cnf(s, axiom, n(X) | ~ n(s(X))). cnf(g, axiom, goal | ~ n(z)).");
  mind.Goal("goal");
  mind.Load();
  const std::atomic<bool> cancelled{true};
  mind.budget.cancelled = &cancelled;
  EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kCancelled);
}

TEST(DecideTest, CyclicHornTheoryIsRefutedFinitely) {
  AgentMind mind(
      "cnf(a, axiom, p(X) | ~ q(X)). cnf(b, axiom, q(X) | ~ p(X)). cnf(g, axiom, goal | ~ p(a)).");
  mind.Goal("goal");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
}

TEST(DecideTest, OccursCheckKeepsUnificationSound) {
  AgentMind mind("cnf(a, axiom, p(X, X)). cnf(g, axiom, goal | ~ p(Y, f(Y))).");
  mind.Goal("goal");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
}

TEST(DecideTest, ContradictionIsInconsistent) {
  AgentMind mind("cnf(law, axiom, ~ hot(X) | ~ cold(X)).");
  mind.Input("hot", 1);
  mind.Input("cold", 1);
  mind.Goal("hot(X)");
  mind.Load();
  mind.Latch(0, {"hot(a)", "cold(a)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kInconsistent);
  EXPECT_THAT(mind.decision.message, HasSubstr("law"));
  EXPECT_THAT(mind.decision.message, HasSubstr("cold(a)"));
  EXPECT_THAT(mind.Conclusions(), IsEmpty());
}

TEST(DecideTest, UniqueNamesSeparateConstants) {
  constexpr std::string_view kTheory = "cnf(other, axiom, other(X) | ~ thing(X) | X = me).";
  for (const bool unique : {false, true}) {
    AgentMind mind(kTheory);
    mind.Input("thing", 1);
    mind.Goal("other(X)", sdk::Goal::Answers::kAll);
    mind.Parameter("unique_names", unique ? "true" : "false");
    mind.Load();
    mind.Latch(0, {"thing(me)", "thing(you)"});
    mind.Decide();
    EXPECT_EQ(mind.Conclusions().size(), unique ? 1U : 0U);
  }
}

/// Where rules conclude that terms differ, "!=" is tried before its arguments are known.
TEST(DecideTest, VariablesDifferFromNothingYet) {
  AgentMind mind(R"(
    cnf(apart, axiom, X != Y | ~ apart(X,Y)).
    cnf(other, axiom, other(X) | X = me | ~ thing(X)).
    cnf(mine, axiom, mine | ~ other(X) | X != me).
    cnf(all, axiom, thing(X)).
  )");
  mind.Input("apart", 2);
  mind.Goal("mine");
  mind.Parameter("unique_names", "true");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
}

}  // namespace
}  // namespace latchwork::pttp
