// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reasoners/pttp/ladder.h"

namespace latchwork::pttp {
namespace {

using ::testing::ElementsAre;

TEST(PlanningTest, LongPlanTakesPolynomialWork) {
  AgentMind mind(kItinerary);
  LoadLadder(mind, 125);
  mind.Latch(1, {"curr_landmark(a50)"});
  mind.Latch(2, {"goal(a75)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("target_landmark(a51)"));
  EXPECT_LT(mind.decision.statistics.inferences, 100'000U);
}

TEST(PlanningTest, UnreachableGoalIsRefuted) {
  AgentMind mind(kItinerary);
  LoadLadder(mind, 10);
  mind.Latch(1, {"curr_landmark(island)"});
  mind.Latch(2, {"goal(a5)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
}

TEST(PlanningTest, AtTheGoalNoStepIsNeeded) {
  AgentMind mind(kItinerary);
  LoadLadder(mind, 3);
  mind.Latch(1, {"curr_landmark(a1)"});
  mind.Latch(2, {"goal(a1)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_EQ(mind.decision.conclusions.size(), 1U);
}

}  // namespace
}  // namespace latchwork::pttp
