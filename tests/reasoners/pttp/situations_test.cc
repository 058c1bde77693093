// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/reasoners/pttp/tower.h"

namespace latchwork::pttp {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

/// How many actions a situation term has.
std::size_t ActionsOf(const logic::Term& situation) {
  std::size_t actions = 0;
  for (const logic::Term* term = &situation; term->kind() == logic::Term::Kind::kCompound;
       term = &term->arguments()[1]) {
    ++actions;
  }
  return actions;
}

class TowerTest : public ::testing::TestWithParam<int> {};

TEST_P(TowerTest, ShortestPlanIsFoundAndExplained) {
  const Tower tower(GetParam());
  AgentMind mind("tower" + std::to_string(GetParam()), kPlanTo);
  LoadElevators(mind);
  EnterTower(mind, tower);
  ASSERT_EQ(mind.Decide().status, sdk::Status::kProved);
  ASSERT_EQ(mind.decision.conclusions.size(), 1U);
  EXPECT_EQ(ActionsOf(mind.decision.conclusions[0].fact.argument(0)),
            static_cast<std::size_t>(tower.steps));
  EXPECT_LT(mind.decision.statistics.inferences, 10'000U);
  EXPECT_FALSE(mind.reasoner.Explain(0).steps.empty());
}

INSTANTIATE_TEST_SUITE_P(Lengths, TowerTest, ::testing::Values(4, 5, 8, 11, 12, 15, 20, 30));

TEST(SituationsTest, PlanRestsOnWhatItsActionsAssume) {
  AgentMind mind(kPlanTo);
  LoadElevators(mind);
  EnterTower(mind, Tower(11));
  mind.Decide();
  std::vector<std::string> assumed;
  for (const std::size_t index : mind.decision.conclusions.at(0).assumptions) {
    assumed.push_back(ToString(mind.decision.assumptions[index].atom));
  }
  EXPECT_THAT(assumed,
              ::testing::IsSupersetOf({"elevator_out_of_order(e0)", "elevator_out_of_order(e1)"}));
}

TEST(SituationsTest, ElevatorOutOfOrderLeavesNoPlan) {
  AgentMind mind(kPlanTo);
  LoadElevators(mind);
  EnterTower(mind, Tower(11));
  mind.Latch(4, {"elevator_out_of_order(e1)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
  mind.Latch(4, {});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
}

/// Carrying things: fluents at(place) and has(thing), which need each other.
constexpr std::string_view kCarry = R"(
fof(here, axiom, ![P] : (start(P) => at(P, s0))).
fof(go, axiom, ![P, Q, S] : ((at(P, S) & way(P, Q)) => at(Q, do(go(Q), S)))).
fof(open, axiom, ![P, Q, K, S] :
  ((at(P, S) & gate(P, Q, K) & has(K, S)) => at(Q, do(go(Q), S)))).
fof(take, axiom, ![P, T, S] : ((at(P, S) & lies(T, P)) => has(T, do(take(T), S)))).
fof(stay, axiom, ![P, T, S] : (at(P, S) => at(P, do(take(T), S)))).
fof(keep, axiom, ![A, T, S] : (has(T, S) => has(T, do(A, S)))).
)";

void LoadCarry(AgentMind& mind) {
  mind.Input("start", 1);
  mind.Input("goal", 1);
  mind.Input("way", 2);
  mind.Input("lies", 2);
  mind.Input("gate", 3);
  mind.Load();
  mind.Latch(0, {"start(a)", "goal(d)"});
  mind.Latch(
      1, {"way(a, b)", "way(b, a)", "way(a, c)", "way(c, a)", "gate(b, d, key)", "lies(key, c)"});
}

TEST(SituationsTest, ThingsAreFetchedFirst) {
  AgentMind mind(std::string(kCarry) +
                 "fof(plan, axiom, ![G, S] : ((goal(G) & at(G, S)) => plan(S))).");
  mind.Goal("plan(S)");
  LoadCarry(mind);
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(),
              ElementsAre("plan(do(go(d), do(go(b), do(go(a), do(take(key), do(go(c), s0))))))"));
}

TEST(SituationsTest, FluentsMayBeFacts) {
  AgentMind mind(std::string(kCarry) +
                 "fof(plan, axiom, ![G, S] : ((goal(G) & at(G, S)) => plan(S))).");
  mind.Goal("plan(S)");
  mind.Input("has", 2);
  LoadCarry(mind);
  mind.Latch(2, {"has(key, s0)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("plan(do(go(d), do(go(b), s0)))"));
}

TEST(SituationsTest, AllAnswersEndWhereSituationsDoNot) {
  AgentMind mind(std::string(kCarry) +
                 "fof(with, axiom, ![P, T, S] : ((at(P, S) & has(T, S)) => with(P, T)))."
                 "fof(visit, axiom, ![P, S] : (at(P, S) => visit(P))).");
  mind.Goal("visit(P)", sdk::Goal::Answers::kAll);
  mind.Goal("with(P, T)", sdk::Goal::Answers::kAll);
  LoadCarry(mind);
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(),
              UnorderedElementsAre("visit(a)", "visit(b)", "visit(c)", "visit(d)", "with(c, key)",
                                   "with(a, key)", "with(b, key)", "with(d, key)"));
  mind.Latch(1, {"way(a, b)", "lies(key, c)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), UnorderedElementsAre("visit(a)", "visit(b)"));
}

TEST(SituationsTest, WhatLooksAtTheWayIsDecidedAsBefore) {
  // Both ways to d are as long; the state after them is the same, but only one goes by c.
  AgentMind mind(std::string(kCarry) + R"(
fof(by, axiom, ![P, S] : by(P, do(go(P), S))).
fof(by_before, axiom, ![P, A, S] : (by(P, S) => by(P, do(A, S)))).
fof(plan, axiom, ![G, P, S] : ((goal(G) & at(G, S) & scenic(P) & by(P, S)) => plan(S))).
)");
  mind.Goal("plan(S)");
  mind.Input("scenic", 1);
  LoadCarry(mind);
  mind.Latch(1, {"way(a, b)", "way(a, c)", "way(b, d)", "way(c, d)", "lies(key, a)"});
  for (const std::string place : {"b", "c"}) {
    mind.Latch(2, {"scenic(" + place + ")"});
    EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
    EXPECT_THAT(mind.Conclusions(), ElementsAre("plan(do(go(d), do(go(" + place + "), s0)))"));
  }
}

TEST(SituationsTest, FirstStepIsThatOfAShortestPlan) {
  AgentMind mind(std::string(kCarry) + R"(
cnf(first, axiom, first(A, do(A, s0))).
fof(later, axiom, ![A, B, S] : (first(A, S) => first(A, do(B, S)))).
fof(next, axiom, ![G, A, S] : ((goal(G) & at(G, S) & first(A, S)) => next(A))).
)");
  mind.Goal("next(A)");
  LoadCarry(mind);
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("next(go(c))"));
}

TEST(SituationsTest, FirstStepIsExplainedByItsPlan) {
  AgentMind mind(std::string(kPlanTo) + R"(
cnf(first, axiom, begins(A, do(A, s0))).
fof(later, axiom, ![A, B, S] : (begins(A, S) => begins(A, do(B, S)))).
fof(next, axiom, ![S, A] : ((plan_to(S) & begins(A, S)) => next(A))).
)");
  LoadElevators(mind, "next(A)");
  EnterTower(mind, Tower(15));
  ASSERT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("next(go(in1))"));
  const sdk::Derivation derivation = mind.reasoner.Explain(0);
  EXPECT_GT(derivation.steps.size(), 30U);
}

TEST(SituationsTest, StaticTestsOfWhatFluentsBindDoNotMatter) {
  AgentMind mind(std::string(kCarry) + R"(
fof(plan, axiom, ![P, S] : ((at(P, S) & wanted(P) & has(key, S)) => plan(S))).
)");
  mind.Goal("plan(S)");
  mind.Input("wanted", 1);
  LoadCarry(mind);
  mind.Latch(2, {"wanted(b)", "wanted(d)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(),
              ElementsAre("plan(do(go(b), do(go(a), do(take(key), do(go(c), s0)))))"));
}

TEST(SituationsTest, RulesWithinASituationAreFollowed) {
  AgentMind mind(std::string(kCarry) + R"(
fof(rich, axiom, ![S] : ((has(gold, S) & has(key, S)) => rich(S))).
fof(home, axiom, ![P, S] : ((at(P, S) & start(P) & rich(S)) => plan(S))).
)");
  mind.Goal("plan(S)");
  LoadCarry(mind);
  mind.Latch(2, {"lies(gold, b)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  ASSERT_EQ(mind.decision.conclusions.size(), 1U);
  EXPECT_EQ(ActionsOf(mind.decision.conclusions[0].fact.argument(0)), 6U);
}

TEST(SituationsTest, EndlessFluentsAreLeftToTheSearch) {
  AgentMind mind(R"(
cnf(zero, axiom, count(0, s0)).
cnf(dark, axiom, dark(s0)).
fof(up, axiom, ![N, S] : ((count(N, S) & dark(S)) => count($sum(N, 1), do(up, S)))).
fof(still, axiom, ![S] : (dark(S) => dark(do(up, S)))).
fof(plan, axiom, ![S] : (count(3, S) => plan(S))).
)");
  mind.Goal("plan(S)");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("plan(do(up, do(up, do(up, s0))))"));
}

TEST(SituationsTest, WithoutStatesThePlanIsAsLong) {
  for (const char* states : {"true", "false"}) {
    AgentMind mind(kPlanTo);
    mind.Parameter("states", states);
    LoadElevators(mind);
    EnterTower(mind, Tower(7));
    ASSERT_EQ(mind.Decide().status, sdk::Status::kProved);
    EXPECT_EQ(ActionsOf(mind.decision.conclusions[0].fact.argument(0)), 7U);
  }
}

}  // namespace
}  // namespace latchwork::pttp
