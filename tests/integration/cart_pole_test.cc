// SPDX-License-Identifier: BSD-3-Clause
//
// The cart and pole, balanced by an Icarus program.
#include <gtest/gtest.h>

#include "tests/integration/seed_runs.h"

namespace latchwork::testing {
namespace {

TEST(CartPoleAgentTest, RandomStartsAndPushes_AllSeedsUprightForAMinute) {
  const auto runs = RunSeeds("icarus/cart_pole.xml", "1-20");
  EXPECT_EQ(runs.size(), 20U);
  ExpectAllReached(runs);
  for (const auto& run : runs) {
    EXPECT_EQ(run.at("measures").at("time_s"), 60.0);
    EXPECT_LT(run.at("measures").at("rms_place_m").get<double>(), 0.6);
  }
}

TEST(CartPoleAgentTest, WithoutTheSecondProcess_TheCartRunsOffItsTrack) {
  const auto runs = RunSeeds("icarus/cart_pole.xml", "1-3", {"--set", "balancer.middle=10"});
  EXPECT_EQ(runs.size(), 3U);
  for (const auto& run : runs) EXPECT_EQ(run.at("outcome"), "failed");
}

}  // namespace
}  // namespace latchwork::testing
