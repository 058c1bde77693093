// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

constexpr std::string_view kReachable = R"(
fof(start, axiom, ![X] : (start(X) => reachable(X))).
fof(step, axiom, ![X, Y] : ((reachable(X) & edge(X, Y)) => reachable(Y))).
)";

void LoadReachable(AgentMind& mind) {
  mind.Input("start", 1);
  mind.Input("edge", 2);
  mind.Goal("reachable(X)", sdk::Goal::Answers::kAll);
  mind.Load();
}

std::string Edge(int from, int to) {
  return "edge(n" + std::to_string(from) + ", n" + std::to_string(to) + ")";
}

/// Two rings with chords and one way from the first to the second; cyclic through and through.
std::vector<std::string> TwoRings(int nodes) {
  std::vector<std::string> edges;
  const int half = nodes / 2;
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < half; ++i) {
      edges.push_back(Edge(ring * half + i, ring * half + (i + 1) % half));
      edges.push_back(Edge(ring * half + i, ring * half + (i * 7 + 3) % half));
    }
  }
  edges.push_back(Edge(half - 1, half));
  return edges;
}

TEST(TablesTest, CyclicGraphIsAnsweredCompletely) {
  AgentMind mind(kReachable);
  LoadReachable(mind);
  mind.Latch(0, {"start(n0)"});
  mind.Latch(1, TwoRings(500));
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kNone);
  EXPECT_EQ(mind.decision.conclusions.size(), 500U);
  EXPECT_LT(mind.decision.statistics.inferences, 10'000U);
  mind.Latch(0, {"start(n250)"});
  EXPECT_EQ(mind.Decide().conclusions.size(), 250U);
}

TEST(TablesTest, LeftAndMutualRecursionEnd) {
  AgentMind mind(R"(
fof(even, axiom, ![X, Y] : ((odd(X) & edge(X, Y)) => even(Y))).
fof(odd, axiom, ![X, Y] : ((even(X) & edge(X, Y)) => odd(Y))).
fof(zero, axiom, ![X] : (start(X) => even(X))).
)");
  mind.Input("start", 1);
  mind.Input("edge", 2);
  mind.Goal("even(X)", sdk::Goal::Answers::kAll);
  mind.Goal("odd(X)", sdk::Goal::Answers::kAll);
  mind.Load();
  mind.Latch(0, {"start(n0)"});
  mind.Latch(1, {Edge(0, 1), Edge(1, 2), Edge(2, 3), Edge(3, 0)});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(),
              UnorderedElementsAre("even(n0)", "even(n2)", "odd(n1)", "odd(n3)"));
}

TEST(TablesTest, PairsOfACycleAgreeWithTheSearchForEach) {
  AgentMind mind(R"(
fof(one, axiom, ![X, Y] : (edge(X, Y) => path(X, Y))).
fof(more, axiom, ![X, Y, Z] : ((edge(X, Y) & path(Y, Z)) => path(X, Z))).
)");
  mind.Input("edge", 2);
  mind.Goal("path(X, Y)", sdk::Goal::Answers::kAll);
  mind.Load();
  mind.Latch(0, {Edge(0, 1), Edge(1, 2), Edge(2, 0), Edge(2, 3)});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_EQ(mind.decision.conclusions.size(), 12U);
}

TEST(TablesTest, ClosingAboveRecursionIsDecided) {
  AgentMind mind(std::string(kReachable) + R"(
fof(cut_off, axiom, ![X] : ((node(X) & ~ linked(X)) => cut_off(X))).
fof(linked, axiom, ![X] : (reachable(X) => linked(X))).
)");
  mind.Input("start", 1);
  mind.Input("edge", 2);
  mind.Input("node", 1);
  mind.Minimize("linked", 1);
  mind.Goal("cut_off(X)", sdk::Goal::Answers::kAll);
  mind.Load();
  mind.Latch(0, {"start(n0)", "node(n0)", "node(n1)", "node(n2)", "node(n3)"});
  mind.Latch(1, {Edge(0, 1), Edge(1, 0), Edge(2, 3), Edge(3, 2)});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("cut_off(n2)", "cut_off(n3)"));
  ASSERT_EQ(mind.decision.conclusions[0].assumptions.size(), 1U);
  const auto& assumption = mind.decision.assumptions[mind.decision.conclusions[0].assumptions[0]];
  EXPECT_EQ(ToString(assumption.atom), "linked(n2)");
  EXPECT_EQ(assumption.state, sdk::Assumption::State::kMade);
}

TEST(TablesTest, TermsThatGrowAreLeftToTheSearch) {
  AgentMind mind(
      "cnf(z, axiom, n(z)). cnf(s, axiom, n(s(X)) | ~ n(X)). cnf(g, axiom, goal(X) | ~ n(X)).");
  mind.Goal("goal(X)", sdk::Goal::Answers::kAll);
  mind.Load();
  mind.budget.depth = 5;
  EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kDepth);
  EXPECT_FALSE(mind.decision.conclusions.empty());
}

TEST(TablesTest, AnswersAreThoseOfTheSearch) {
  constexpr std::string_view kTheory = R"(
fof(a, axiom, ![X, Y, Z] : ((r(X, Y) & s(Y, Z) & X != Z) => t(X, pair(Y, Z)))).
fof(b, axiom, ![X, P] : ((t(X, P) & ~ hidden(X)) => shown(X, P))).
fof(c, axiom, ![X, Y] : ((r(X, Y) & $less(X, Y)) => up(X, $sum(X, Y)))).
fof(d, axiom, ![X, P, S] : ((shown(X, P) & up(X, S)) => answer(S, P))).
)";
  std::vector<std::vector<std::string>> found;
  for (const char* tables : {"true", "false"}) {
    AgentMind mind(std::string("answers_") + tables, kTheory);
    for (const char* name : {"r", "s"}) mind.Input(name, 2);
    mind.Input("hidden", 1);
    mind.Minimize("hidden", 1);
    mind.Goal("answer(S, P)", sdk::Goal::Answers::kAll);
    mind.Parameter("tables", tables);
    mind.Parameter("unique_names", "true");
    mind.Load();
    mind.Latch(0, {"r(1, 2)", "r(2, 3)", "r(3, 1)", "r(2, 2)", "s(2, 1)", "s(3, 1)", "s(2, 3)"});
    mind.Latch(1, {"hidden(3)"});
    EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
    found.push_back(mind.Conclusions());
    std::sort(found.back().begin(), found.back().end());
  }
  EXPECT_EQ(found[0].size(), 4U);
  EXPECT_EQ(found[0], found[1]);
}

TEST(TablesTest, NoAnswerIsRefuted) {
  AgentMind mind(kReachable);
  LoadReachable(mind);
  mind.Latch(0, {});
  mind.Latch(1, TwoRings(20));
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
  EXPECT_THAT(mind.Conclusions(), IsEmpty());
}

TEST(TablesTest, AnswerIsExplained) {
  AgentMind mind(kReachable);
  LoadReachable(mind);
  mind.Latch(0, {"start(n0)"});
  mind.Latch(1, {Edge(0, 1), Edge(1, 0)});
  ASSERT_EQ(mind.Decide().conclusions.size(), 2U);
  const sdk::Derivation derivation = mind.reasoner.Explain(1);
  ASSERT_FALSE(derivation.steps.empty());
  EXPECT_EQ(derivation.steps.back().conclusion, "reachable(n1)");
}

}  // namespace
}  // namespace latchwork::pttp
