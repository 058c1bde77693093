// SPDX-License-Identifier: BSD-3-Clause
//
// Tables solve bodies batch by batch: what more rows than a batch holds, equal keys and values at
// both ends of the arithmetic must not change.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {
namespace {

constexpr std::string_view kDistances = R"(
cnf(place, axiom, ( ~ seen(O, D) | distance(thing(O), $sum(D, 1.0)) )).
fof(one, axiom, ![O, A, B] : ~ (distance(O, A) & distance(O, B) & $less(A, B))).
fof(pair, axiom, ![O, P, A, B] :
  ((distance(O, A) & next(O, P) & distance(P, B) & $lesseq(A, B)) => rises(O, P))).
)";

std::vector<std::string> Seen(int count) {
  std::vector<std::string> facts;
  for (int i = 0; i < count; ++i) facts.push_back(fmt::format("seen(n{}, {}.5)", i, i % 7));
  return facts;
}

std::vector<std::string> Next(int count) {
  std::vector<std::string> facts;
  for (int i = 1; i < count; ++i) {
    facts.push_back(fmt::format("next(thing(n{}), thing(n{}))", i - 1, i));
  }
  return facts;
}

struct TableBatchesTest : ::testing::Test {
  AgentMind mind{kDistances};

  void SetUp() override {
    mind.Input("seen", 2);
    mind.Input("next", 2);
    mind.Goal("rises(O, P)", sdk::Goal::Answers::kAll);
    mind.Load();
  }
};

TEST_F(TableBatchesTest, MoreRowsThanABatch_AllAnswersInOrder) {
  mind.Latch(0, Seen(200));
  mind.Latch(1, Next(200));
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  ASSERT_EQ(mind.decision.conclusions.size(), 199U - 199U / 7U);
  EXPECT_EQ(ToString(mind.decision.conclusions.front().fact), "rises(thing(n0), thing(n1))");
  EXPECT_EQ(ToString(mind.decision.conclusions[6].fact), "rises(thing(n7), thing(n8))");
  EXPECT_EQ(ToString(mind.decision.conclusions.back().fact), "rises(thing(n198), thing(n199))");
}

TEST_F(TableBatchesTest, TwoValuesForOneKey_AreAContradiction) {
  auto facts = Seen(40);
  facts.emplace_back("seen(n17, 30.0)");
  mind.Latch(0, facts);
  mind.Latch(1, Next(2));
  EXPECT_EQ(mind.Decide().status, sdk::Status::kInconsistent);
}

TEST_F(TableBatchesTest, TheSameFactTwice_IsNoContradiction) {
  auto facts = Seen(40);
  facts.push_back(facts[17]);
  mind.Latch(0, facts);
  mind.Latch(1, Next(3));
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_EQ(mind.decision.conclusions.size(), 2U);
}

TEST_F(TableBatchesTest, AnIntegerForAReal_IsComparedByValue) {
  mind.Latch(0, {"seen(n0, 1)", "seen(n1, 1.0)", "seen(n2, a)"});
  mind.Latch(1, Next(3));
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_EQ(mind.decision.conclusions.size(), 1U);
}

}  // namespace
}  // namespace latchwork::pttp
