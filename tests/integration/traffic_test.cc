// SPDX-License-Identifier: BSD-3-Clause
//
// A car in traffic, driven by an Icarus program.
#include <gtest/gtest.h>

#include "tests/integration/seed_runs.h"

namespace latchwork::testing {
namespace {

/// All seeds, some at a time: a test does not take long on a machine that is busy.
class TrafficSeedsTest : public ::testing::TestWithParam<const char*> {};

TEST_P(TrafficSeedsTest, ReachTheirExitInTimeWithoutACollision) {
  const auto runs = RunSeeds("icarus/traffic.xml", GetParam());
  EXPECT_EQ(runs.size(), 5U);
  ExpectAllReached(runs);
  for (const auto& run : runs) {
    EXPECT_EQ(run.at("measures").at("collisions"), 0);
    EXPECT_EQ(run.at("measures").at("others_touching"), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, TrafficSeedsTest,
                         ::testing::Values("1-5", "6-10", "11-15", "16-20"));

TEST(TrafficAgentTest, DenseTraffic_NoCollision) {
  const auto runs = RunSeeds("icarus/traffic.xml", "1-5",
                             {"--set", "world.density=20", "--set", "world.brakings=4"});
  EXPECT_EQ(runs.size(), 5U);
  for (const auto& run : runs) EXPECT_EQ(run.at("measures").at("collisions"), 0);
}

}  // namespace
}  // namespace latchwork::testing
