// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using State = sdk::Assumption::State;

constexpr std::string_view kForward = R"(
fof(forward, axiom, ![V] : ((speed(V) & ~ halt_robot) => fwd(V))).
fof(halt, axiom, ![O] : (ahead(O) => halt_robot)).
)";

void Prepare(AgentMind& mind) {
  mind.Input("speed", 1);
  mind.Input("ahead", 1);
  mind.Input("halt_robot", 0);
  mind.Minimize("halt_robot", 0);
  mind.Goal("fwd(V)");
  mind.Load();
  mind.Latch(0, {"speed(0.5)"});
}

TEST(MinimizedTest, DefaultIsMadeAndNamed) {
  AgentMind mind(kForward);
  Prepare(mind);
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  ASSERT_EQ(mind.decision.assumptions.size(), 1U);
  EXPECT_EQ(ToString(mind.decision.assumptions[0].atom), "halt_robot");
  EXPECT_EQ(mind.decision.assumptions[0].state, State::kMade);
  EXPECT_THAT(mind.decision.conclusions.at(0).assumptions, ElementsAre(0U));
}

TEST(MinimizedTest, DefaultIsRetractedAndRestored) {
  AgentMind mind(kForward);
  Prepare(mind);
  mind.Latch(1, {"halt_robot"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
  ASSERT_EQ(mind.decision.assumptions.size(), 1U);
  EXPECT_EQ(mind.decision.assumptions[0].state, State::kRetracted);
  mind.Latch(1, {});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_EQ(mind.decision.assumptions.at(0).state, State::kMade);
  mind.Latch(1, {"ahead(box)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
}

TEST(MinimizedTest, BoundThatClosesIsReported) {
  AgentMind mind(R"(
fof(calm, axiom, (~ alarm => go)).
fof(end, axiom, n(z)).
fof(step, axiom, ![X] : (n(X) => n(s(X)))).
fof(alarm, axiom, (n(s(s(s(s(s(z)))))) => alarm)).
)");
  mind.Minimize("alarm", 0, 3);
  mind.Goal("go");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  ASSERT_EQ(mind.decision.assumptions.size(), 1U);
  EXPECT_EQ(mind.decision.assumptions[0].state, State::kMadeByBound);
}

TEST(MinimizedTest, DefaultThatRestsOnItselfIsUnknown) {
  AgentMind mind(
      "fof(a, axiom, (~ p => q)). fof(b, axiom, (~ q => p)). fof(g, axiom, (q => goal)).");
  mind.Minimize("p", 0);
  mind.Minimize("q", 0);
  mind.Goal("goal");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
  EXPECT_THAT(mind.decision.message, HasSubstr("rests on itself"));
}

TEST(MinimizedTest, NeverGroundClosingIsUnknown) {
  AgentMind mind("fof(a, axiom, ![X] : (~ p(X) => goal)).");
  mind.Minimize("p", 1);
  mind.Goal("goal");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
  EXPECT_THAT(mind.decision.message, HasSubstr("p/1"));
}

TEST(MinimizedTest, ClosingWaitsForItsArguments) {
  AgentMind mind("fof(a, axiom, ![X] : ((~ taken(X) & seat(X)) => free(X))).");
  mind.Minimize("taken", 1);
  mind.Input("taken", 1);
  mind.Input("seat", 1);
  mind.Goal("free(X)", sdk::Goal::Answers::kAll);
  mind.Load();
  mind.Latch(0, {"seat(a)", "seat(b)", "seat(c)", "taken(b)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("free(a)", "free(c)"));
  EXPECT_EQ(mind.decision.assumptions.size(), 3U);
}

}  // namespace
}  // namespace latchwork::pttp
