// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/worlds/cleaning/cleaning_fixture.h"
#include "worlds/cleaning/reach.h"

namespace latchwork::cleaning {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using State = sdk::Outcome::State;

using CleaningWorldTest = CleaningFixture;

TEST_F(CleaningWorldTest, ShippedFloor_IsTwentyByTwelveMetres) {
  ASSERT_EQ(logic::Format(Load({{"plan", ""}})), "");
  EXPECT_EQ(world_.state().plan.width() * kTile, 20);
  EXPECT_EQ(world_.state().plan.height() * kTile, 12);
  EXPECT_GT(Measure("floor_m2"), 150);
}

TEST_F(CleaningWorldTest, PlanThatIsNotThere_IsReportedAtItsParameter) {
  EXPECT_THAT(logic::Format(Load({{"plan", "/nowhere/plan.txt"}})),
              HasSubstr("agent.xml:5:5: error: cannot read the plan"));
}

TEST_F(CleaningWorldTest, DockInANiche_IsRefused) {
  EXPECT_THAT(logic::Format(Load({}, "#####\n#D..#\n#...#\n#####\n")),
              HasSubstr("no room for the robot"));
}

TEST_F(CleaningWorldTest, FirstTick_TellsOfItself) {
  ASSERT_EQ(logic::Format(Load()), "");
  EXPECT_EQ(Sensed(kRobot), "tile_size(0.25) dock(2, 5) ");
  EXPECT_THAT(Sensed(kPower), HasSubstr("battery(1.0) charging"));
  EXPECT_THAT(Sensed(kPose), HasSubstr("pose(0.625, 1.375, "));
  EXPECT_EQ(Sensed(kTouch), "");
}

TEST_F(CleaningWorldTest, View_ShowsFloorDirtAndWallsNearby) {
  ASSERT_EQ(logic::Format(Load()), "");
  const std::string view = Sensed(kView);
  EXPECT_THAT(view, HasSubstr("picture(1)"));
  EXPECT_THAT(view, HasSubstr("tile(2, 5, dirty)"));
  EXPECT_THAT(view, HasSubstr("tile(0, 5, blocked)"));
  EXPECT_THAT(view, HasSubstr("row_in_view(5)"));
  EXPECT_THAT(view, Not(HasSubstr("tile(10,"))) << "too far away";
  Ticks(1, 0, 0);
  Sensed(kView);
  EXPECT_FALSE(sensors_[kView].updated) << "every fourth tick";
}

TEST_F(CleaningWorldTest, Overlooked_ShowsDirtAsCleanNowAndThen) {
  ASSERT_EQ(logic::Format(Load({{"overlooked", "0.5"}})), "");
  const std::string view = Sensed(kView);
  EXPECT_THAT(view, HasSubstr("dirty"));
  EXPECT_THAT(view, HasSubstr("clean"));
}

TEST_F(CleaningWorldTest, Ranges_MeasureFromTheRim) {
  ASSERT_EQ(logic::Format(Load()), "");
  Face(std::numbers::pi);
  const double gap = world_.state().base.pose().x - kTile - 0.3;
  Sensed(kRanges);
  EXPECT_NEAR(sensors_[kRanges].facts[0].argument(1).number(), gap, 1e-3);
  EXPECT_NEAR(sensors_[kRanges].facts[4].argument(1).number(), 2, 1e-9)
      << "nothing within the range";
}

TEST_F(CleaningWorldTest, Drive_SweepsWhatItPasses) {
  ASSERT_EQ(logic::Format(Load()), "");
  Face(0);
  Ticks(30, 0.5, 0);
  EXPECT_THAT(Sensed(kView), HasSubstr("tile(6, 5, clean)"));
  EXPECT_GT(Measure("clean_part"), 0.1);
  EXPECT_LT(Measure("clean_part"), 0.6);
  EXPECT_NEAR(Measure("distance_m"), world_.state().base.pose().x - 0.625, 1e-2);
}

TEST_F(CleaningWorldTest, RunsIntoTheWall_BumpsOnce) {
  ASSERT_EQ(logic::Format(Load()), "");
  Face(std::numbers::pi);
  Ticks(20, 0.5, 0);
  EXPECT_EQ(Sensed(kTouch), "bump(ahead) ");
  EXPECT_EQ(Measure("bumps"), 1);
  EXPECT_EQ(world_.outcome().state, State::kRunning);
}

TEST_F(CleaningWorldTest, BatteryEmpty_RunFails) {
  ASSERT_EQ(logic::Format(Load({{"capacity", "200"}})), "");
  Face(0);
  Ticks(20, 0.5, 0);
  Ticks(100, 0, 1);
  EXPECT_EQ(world_.outcome().state, State::kFailed);
  EXPECT_THAT(world_.outcome().message, HasSubstr("battery is empty"));
}

TEST_F(CleaningWorldTest, CleanAndBackAtTheDock_RunReached) {
  ASSERT_EQ(logic::Format(Load({{"target", "0.1"}})), "");
  Face(0);
  Ticks(25, 0.5, 0);
  EXPECT_EQ(world_.outcome().state, State::kRunning) << "clean, but not at home";
  for (int i = 0; i < 60 && world_.outcome().state == State::kRunning; ++i) Tick(-0.5, 0);
  EXPECT_EQ(world_.outcome().state, State::kReached) << Measure("clean_part");
  EXPECT_EQ(Measure("charges"), 1);
}

TEST_F(CleaningWorldTest, BoxPut_BlocksTilesAndLessIsInReach) {
  ASSERT_EQ(logic::Format(Load()), "");
  const double before = Measure("floor_m2");
  EXPECT_TRUE(world_.HandleEvent(0, Make("box_put", {Number(2.5), Number(1.5)})).empty());
  EXPECT_LT(Measure("floor_m2"), before);
  EXPECT_EQ(world_.state().plan.At({9, 5}), Surface::kBox);
  EXPECT_EQ(world_.state().plan.At({10, 6}), Surface::kBox);
  EXPECT_EQ(world_.state().plan.At({11, 6}), Surface::kFloor);
}

TEST_F(CleaningWorldTest, BoxOnTheRobot_IsRefused) {
  ASSERT_EQ(logic::Format(Load()), "");
  EXPECT_FALSE(world_.HandleEvent(0, Make("box_put", {Number(0.7), Number(1.4)})).empty());
  EXPECT_FALSE(world_.HandleEvent(0, Make("box_put", {Number(900), Number(1.4)})).empty());
}

TEST_F(CleaningWorldTest, DirtSpilled_IsDirtyAgain) {
  ASSERT_EQ(logic::Format(Load()), "");
  Face(0);
  Ticks(30, 0.5, 0);
  const double clean = Measure("clean_part");
  EXPECT_TRUE(
      world_.HandleEvent(0, Make("dirt_spilled", {Number(1.4), Number(1.4), Number(0.4)})).empty());
  EXPECT_LT(Measure("clean_part"), clean);
}

TEST_F(CleaningWorldTest, Boxes_StandWhereTheSeedPutsThem) {
  ASSERT_EQ(logic::Format(Load({{"plan", ""}, {"boxes", "5"}}, kRoom, 7)), "");
  const auto boxes = [&] {
    std::size_t count = 0;
    for (std::size_t n = 0; n < world_.state().plan.size(); ++n) {
      count += world_.state().plan.At(world_.state().plan.TileOf(n)) == Surface::kBox ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(boxes(), 20U);
  const std::string pose = Sensed(kPose);
  ASSERT_EQ(logic::Format(Load({{"plan", ""}, {"boxes", "5"}}, kRoom, 7)), "");
  EXPECT_EQ(Sensed(kPose), pose);
  ASSERT_EQ(logic::Format(Load({{"plan", ""}, {"boxes", "5"}}, kRoom, 8)), "");
  EXPECT_NE(Sensed(kPose), pose);
}

// With these seeds a box would stand so near a door that only a robot that minds centimetres gets
// into the room.
TEST_F(CleaningWorldTest, Boxes_LeaveWideWaysThroughDoors) {
  const auto count = [](const std::vector<char>& tiles) {
    return static_cast<double>(std::count(tiles.begin(), tiles.end(), char{1}));
  };
  for (const std::uint64_t seed : {27U, 38U}) {
    ASSERT_EQ(logic::Format(Load({{"plan", ""}, {"boxes", "5"}}, kRoom, seed)), "");
    const CleaningState& state = world_.state();
    EXPECT_GE(count(TilesInReach(state.plan, 0.37, state.brush)), 0.95 * count(state.in_reach))
        << "seed " << seed;
  }
}

TEST_F(CleaningWorldTest, Draw_WritesTwoPictures) {
  ASSERT_EQ(logic::Format(Load()), "");
  Face(0);
  Ticks(20, 0.5, 0);
  const auto files = world_.Draw(folder_.path());
  ASSERT_EQ(files.size(), 2U);
  for (const auto& file : files) EXPECT_GT(std::filesystem::file_size(file), 1000U);
}

}  // namespace
}  // namespace latchwork::cleaning
