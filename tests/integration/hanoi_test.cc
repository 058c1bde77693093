// SPDX-License-Identifier: BSD-3-Clause
//
// The Tower of Hanoi, played by an Icarus program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/integration/seed_runs.h"

namespace latchwork::testing {
namespace {

TEST(HanoiTest, FiveDisksWithDisturbances_AllSeedsReached) {
  const auto runs = RunSeeds("icarus/hanoi.xml", "1-20");
  EXPECT_EQ(runs.size(), 20U);
  ExpectAllReached(runs);
  double hand_moves = 0;
  double slips = 0;
  for (const auto& run : runs) {
    hand_moves += run.at("measures").at("hand_moves").get<double>();
    slips += run.at("measures").at("slips").get<double>();
    EXPECT_EQ(run.at("measures").at("refusals"), 0);
  }
  EXPECT_GT(hand_moves, 20);
  EXPECT_GT(slips, 5);
}

TEST(HanoiTest, Undisturbed_TakesTheLeastMoves) {
  const auto runs = RunSeeds("icarus/hanoi.xml", "1-20",
                             {"--set", "world.hand_every=0", "--set", "world.slip=0"});
  EXPECT_EQ(runs.size(), 20U);
  ExpectAllReached(runs);
  for (const auto& run : runs) {
    EXPECT_EQ(run.at("measures").at("moves"), run.at("measures").at("least_moves"));
  }
}

TEST(HanoiTest, RestlessHand_IsOutplayed) {
  const auto runs = RunSeeds("icarus/hanoi.xml", "1-5",
                             {"--set", "world.hand_every=6", "--set", "world.start=tower"});
  EXPECT_EQ(runs.size(), 5U);
  ExpectAllReached(runs);
}

}  // namespace
}  // namespace latchwork::testing
