// SPDX-License-Identifier: BSD-3-Clause
//
// Bumper cars, driven by an Icarus program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/integration/seed_runs.h"

namespace latchwork::testing {
namespace {

TEST(BumperCarsTest, Collision_AllSeedsReached) {
  const auto runs = RunSeeds("icarus/bumper_cars.xml", "1-20");
  EXPECT_EQ(runs.size(), 20U);
  ExpectAllReached(runs);
  for (const auto& run : runs) {
    EXPECT_EQ(run.at("measures").at("enemies_rammed"), 2);
    EXPECT_EQ(run.at("measures").at("friends_tapped"), 2);
  }
}

TEST(BumperCarsTest, Day_AllSeedsReached) {
  const auto runs = RunSeeds("icarus/bumper_day.xml", "1-20");
  EXPECT_EQ(runs.size(), 20U);
  ExpectAllReached(runs);
  for (const auto& run : runs) {
    EXPECT_GE(run.at("measures").at("spills"), 3);
    EXPECT_GE(run.at("measures").at("thrills"), 5);
    EXPECT_GT(run.at("measures").at("time_s"), 92);
  }
}

class BumperPlanTest : public ::testing::TestWithParam<const char*> {};

TEST_P(BumperPlanTest, OtherFormsOfThePlan_ReachTheSame) {
  const auto runs = RunSeeds("icarus/bumper_cars.xml", "1-5",
                             {"--set", std::string("driver.plan=") + GetParam()});
  EXPECT_EQ(runs.size(), 5U);
  ExpectAllReached(runs);
}

INSTANTIATE_TEST_SUITE_P(Plans, BumperPlanTest, ::testing::Values("tree", "universal"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace latchwork::testing
