// SPDX-License-Identifier: BSD-3-Clause
//
// A car in traffic, driven by an Icarus program.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

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

std::size_t LongTripsInTime(const std::string& passing) {
  const auto runs =
      RunSeeds("icarus/traffic.xml", "1-10",
               {"--ticks", "6000", "--set", "world.exit=5000", "--set", "world.slack=1.2", "--set",
                "world.density=6", "--set", "driver.passing=" + passing});
  EXPECT_EQ(runs.size(), 10U);
  std::size_t reached = 0;
  for (const auto& run : runs) {
    EXPECT_EQ(run.at("measures").at("collisions"), 0);
    reached += run.at("outcome") == "reached" ? 1 : 0;
  }
  return reached;
}

TEST(TrafficAgentTest, LongTrip_IsInTimeByPassing) {
  EXPECT_EQ(LongTripsInTime("fastest"), 10U);
  EXPECT_LT(LongTripsInTime("never"), 6U);
}

TEST(TrafficAgentTest, DenseTraffic_NoCollision) {
  const auto runs = RunSeeds("icarus/traffic.xml", "1-5",
                             {"--set", "world.density=20", "--set", "world.brakings=4"});
  EXPECT_EQ(runs.size(), 5U);
  for (const auto& run : runs) EXPECT_EQ(run.at("measures").at("collisions"), 0);
}

}  // namespace
}  // namespace latchwork::testing
