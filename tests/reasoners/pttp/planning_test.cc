// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {
namespace {

using ::testing::ElementsAre;

constexpr std::string_view kItinerary = R"(
fof(here, axiom, ![L] : (curr_landmark(L) => robot_at(L, s0))).
fof(go, axiom, ![L, M, S] : ((robot_at(L, S) & adjacent(L, M)) => robot_at(M, do(go(M), S)))).
fof(first, axiom, ![L] : first(do(go(L), s0), L)).
fof(later, axiom, ![A, S, L] : (first(S, L) => first(do(A, S), L))).
fof(target, axiom, ![G, S, L] : ((goal(G) & robot_at(G, S) & first(S, L)) => target_landmark(L))).
)";

/// A ladder of two rails of `length` landmarks each: long shortest paths, and many others.
std::vector<std::string> Ladder(int length) {
  std::vector<std::string> facts;
  const auto edge = [&](const std::string& a, const std::string& b) {
    facts.push_back("adjacent(" + a + "," + b + ")");
    facts.push_back("adjacent(" + b + "," + a + ")");
  };
  const auto name = [](char rail, int i) { return std::string(1, rail) + std::to_string(i); };
  for (int i = 0; i < length; ++i) {
    edge(name('a', i), name('b', i));
    if (i + 1 == length) break;
    edge(name('a', i), name('a', i + 1));
    edge(name('b', i), name('b', i + 1));
  }
  return facts;
}

void Prepare(AgentMind& mind, int length) {
  for (const char* name : {"curr_landmark", "goal"}) mind.Input(name, 1);
  mind.Input("adjacent", 2);
  mind.Goal("target_landmark(L)");
  mind.Load();
  mind.Latch(0, Ladder(length));
}

TEST(PlanningTest, LongPlanTakesPolynomialWork) {
  AgentMind mind(kItinerary);
  Prepare(mind, 125);
  mind.Latch(1, {"curr_landmark(a50)"});
  mind.Latch(2, {"goal(a75)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("target_landmark(a51)"));
  EXPECT_LT(mind.decision.statistics.inferences, 100'000U);
}

TEST(PlanningTest, UnreachableGoalIsRefuted) {
  AgentMind mind(kItinerary);
  Prepare(mind, 10);
  mind.Latch(1, {"curr_landmark(island)"});
  mind.Latch(2, {"goal(a5)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
}

TEST(PlanningTest, AtTheGoalNoStepIsNeeded) {
  AgentMind mind(kItinerary);
  Prepare(mind, 3);
  mind.Latch(1, {"curr_landmark(a1)"});
  mind.Latch(2, {"goal(a1)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_EQ(mind.decision.conclusions.size(), 1U);
}

}  // namespace
}  // namespace latchwork::pttp
