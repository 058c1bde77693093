// SPDX-License-Identifier: BSD-3-Clause
//
// A car in traffic, driven by an Icarus program.
#include <gtest/gtest.h>

#include "tests/integration/seed_runs.h"

namespace latchwork::testing {
namespace {

TEST(TrafficAgentTest, AllSeedsReachTheirExitInTimeWithoutACollision) {
  const auto runs = RunSeeds("icarus/traffic.xml", "1-20");
  EXPECT_EQ(runs.size(), 20U);
  ExpectAllReached(runs);
  for (const auto& run : runs) {
    EXPECT_EQ(run.at("measures").at("collisions"), 0);
    EXPECT_EQ(run.at("measures").at("others_touching"), 0);
  }
}

TEST(TrafficAgentTest, DenseTraffic_NoCollision) {
  const auto runs = RunSeeds("icarus/traffic.xml", "1-5",
                             {"--set", "world.density=20", "--set", "world.brakings=4"});
  EXPECT_EQ(runs.size(), 5U);
  for (const auto& run : runs) EXPECT_EQ(run.at("measures").at("collisions"), 0);
}

}  // namespace
}  // namespace latchwork::testing
