// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A robot in the middle of a wide floor of which it sees 9 x 9 tiles, its dock in tile 5, 5.
class CleanerTest : public ::testing::Test {
 protected:
  CleanerTest() {
    mind_.Latch("robot", {"tile_size(0.25)", "dock(5, 5)"});
    mind_.Latch("power", {"battery(1.0)", "charging"});
    Stand("1.375", "1.375", "0.0");
    See(1, "dirty");
    Clear();
  }
  void Stand(const std::string& x, const std::string& y, const std::string& heading) {
    mind_.Latch("pose", {"pose(" + x + ", " + y + ", " + heading + ")"});
  }
  /// Tiles 1 to 9 in both directions, those around tile 5, 5 clean.
  void See(int picture, const std::string& state) {
    std::vector<std::string> view = {"picture(" + std::to_string(picture) + ")"};
    for (int j = 1; j <= 9; ++j) {
      view.push_back("row_in_view(" + std::to_string(j) + ")");
      for (int i = 1; i <= 9; ++i) {
        const bool swept = i >= 4 && i <= 6 && j >= 4 && j <= 6;
        view.push_back("tile(" + std::to_string(i) + ", " + std::to_string(j) + ", " +
                       (swept ? "clean" : state) + ")");
      }
    }
    mind_.Latch("view", view);
  }
  void Clear(const std::string& ahead = "2.0") {
    mind_.Latch("ranges", {"range(0, " + ahead + ")"});
  }

  LayerMind mind_{"cleaner", {}, kIcarusMind};
};

TEST_F(CleanerTest, DirtAhead_DrivesAlongTheLane) {
  EXPECT_THAT(mind_.Decide(), ElementsAre("drive(0.5, 0.0)"));
}

TEST_F(CleanerTest, LooksAway_TurnsFirst) {
  Stand("1.375", "1.375", "1.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("drive(0, -3.0)"));
}

TEST_F(CleanerTest, SomethingCloseAhead_Slows) {
  Clear("0.2");
  EXPECT_THAT(mind_.Decide(), ElementsAre("drive(0.25, 0.0)"));
}

TEST_F(CleanerTest, AllClean_StaysAtItsDock) {
  See(1, "clean");
  EXPECT_THAT(mind_.Decide(), IsEmpty());
}

TEST_F(CleanerTest, AllCleanAwayFromItsDock_GoesHome) {
  See(1, "clean");
  mind_.Latch("power", {"battery(1.0)"});
  Stand("1.875", "1.375", "3.14159265");
  const auto acts = mind_.Decide();
  ASSERT_EQ(acts.size(), 1U);
  EXPECT_THAT(acts[0], ::testing::StartsWith("drive(0.5, "));
}

TEST_F(CleanerTest, BatteryLow_GoesHomeAndStaysUntilFull) {
  mind_.Decide();
  mind_.Latch("power", {"battery(0.05)"});
  Stand("1.875", "1.375", "3.14159265");
  EXPECT_THAT(mind_.Decide()[0], ::testing::StartsWith("drive(0.5, "));
  Stand("1.375", "1.375", "3.14159265");
  mind_.Latch("power", {"battery(0.3)", "charging"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("drive(0, 0)"));
  mind_.Latch("power", {"battery(0.99)", "charging"});
  EXPECT_NE(mind_.Decide(), std::vector<std::string>{"drive(0, 0)"});
}

TEST_F(CleanerTest, BatteryLowButEnoughForTheWay_GoesOn) {
  mind_.Latch("power", {"battery(0.2)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("drive(0.5, 0.0)"));
}

TEST_F(CleanerTest, Bump_BacksOffForAWhile) {
  mind_.Decide();
  mind_.Latch("touch", {"bump(ahead)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("drive(-0.15, 0)"));
  mind_.Latch("touch", {});
  EXPECT_THAT(mind_.Decide(), ElementsAre("drive(-0.15, 0)"));
  for (int cycle = 0; cycle < 5; ++cycle) mind_.Decide();
  EXPECT_THAT(mind_.Decide(), ElementsAre("drive(0.5, 0.0)"));
}

TEST_F(CleanerTest, BumpBehind_DrivesOn) {
  mind_.Latch("touch", {"bump(behind)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("drive(0.15, 0)"));
}

}  // namespace
}  // namespace latchwork::test
