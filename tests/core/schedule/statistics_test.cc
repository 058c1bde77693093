// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/schedule/statistics.h"

#include <gtest/gtest.h>

#include "core/schedule/layer_tally.h"
#include "tests/core/schedule/fakes.h"

namespace latchwork::schedule {
namespace {

using State = sdk::Assumption::State;

TEST(DescribeTest, EmptySampleIsAllZero) {
  const Spread spread = Describe({});
  EXPECT_EQ(spread.mean, 0);
  EXPECT_EQ(spread.max, 0);
}

TEST(DescribeTest, OneValueHasNoSpread) {
  const Spread spread = Describe({4});
  EXPECT_EQ(spread.mean, 4);
  EXPECT_EQ(spread.sd, 0);
  EXPECT_EQ(spread.p50, 4);
  EXPECT_EQ(spread.p99, 4);
}

TEST(DescribeTest, FiguresOfOneToTwoHundred) {
  std::vector<double> sample;
  for (int i = 200; i > 0; --i) sample.push_back(i);
  const Spread spread = Describe(sample);
  EXPECT_EQ(spread.mean, 100.5);
  EXPECT_NEAR(spread.sd, 57.879, 0.001);
  EXPECT_EQ(spread.p50, 100);
  EXPECT_EQ(spread.p99, 198);
  EXPECT_EQ(spread.max, 200);
}

class LayerTallyTest : public ::testing::Test {
 protected:
  void Count(const std::vector<std::pair<std::string, State>>& assumptions) {
    sdk::Decision decision;
    for (const auto& [name, state] : assumptions) {
      decision.assumptions.push_back({logic::Fact(symbols.Intern(name)), state});
    }
    tally.CountDecision(decision, std::chrono::microseconds(5));
  }

  logic::SymbolTable symbols;
  LayerTally tally{10};
};

TEST_F(LayerTallyTest, CountsDefaultsThatWereMadeAndAreRetracted) {
  Count({{"a", State::kMade}, {"b", State::kMadeByBound}, {"c", State::kRetracted}});
  Count({{"a", State::kRetracted}, {"b", State::kRetracted}, {"c", State::kRetracted}});
  Count({{"a", State::kRetracted}, {"b", State::kMade}});
  Count({{"a", State::kMade}, {"b", State::kRetracted}});
  EXPECT_EQ(tally.Sum().retracted, 3U);
  EXPECT_EQ(tally.Sum().assumed_by_bound, 1U);
}

TEST_F(LayerTallyTest, CountsLimitsTimesAndInferences) {
  sdk::Decision decision;
  decision.limit = sdk::Limit::kDepth;
  decision.statistics.inferences = 10;
  tally.CountDecision(decision, std::chrono::microseconds(3));
  decision.limit = sdk::Limit::kNone;
  decision.statistics.inferences = 20;
  tally.CountDecision(decision, std::chrono::microseconds(5));
  const LayerStatistics sum = tally.Sum();
  EXPECT_EQ(sum.decisions, 2U);
  EXPECT_EQ(sum.budget_hits, 1U);
  EXPECT_EQ(sum.inferences.mean, 15);
  EXPECT_EQ(sum.time_us.mean, 4);
  EXPECT_EQ(sum.time_us.max, 5);
}

TEST(LockstepResultTest, NamesLayersPluginsAndMeasures) {
  testing::FakeAgent fake;
  fake.AddLayer({}, {});
  const RunResult result = fake.Start({}, 42)->Run();
  EXPECT_EQ(result.seed, 42U);
  ASSERT_EQ(result.layers.size(), 1U);
  EXPECT_EQ(result.layers[0].name, "l0");
  EXPECT_EQ(result.layers[0].plugin, "layer0");
  EXPECT_EQ(result.layers[0].reasoner, "reasoner0");
  EXPECT_EQ(result.layers[0].decisions, 10U);
  ASSERT_EQ(result.measures.size(), 1U);
  EXPECT_EQ(result.measures[0].first, "collisions");
}

}  // namespace
}  // namespace latchwork::schedule
