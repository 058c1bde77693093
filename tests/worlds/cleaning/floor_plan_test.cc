// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cleaning/floor_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/worlds/cleaning/cleaning_fixture.h"
#include "worlds/cleaning/reach.h"

namespace latchwork::cleaning {
namespace {

using ::testing::HasSubstr;

FloorPlan Read(std::string_view text) {
  logic::Diagnostics diagnostics;
  FloorPlan plan = ReadFloorPlan(text, "plan.txt", diagnostics);
  EXPECT_EQ(logic::Format(diagnostics), "");
  return plan;
}

std::string Complaints(std::string_view text) {
  logic::Diagnostics diagnostics;
  ReadFloorPlan(text, "plan.txt", diagnostics);
  return logic::Format(diagnostics);
}

TEST(FloorPlanTest, Text_NorthernRowComesFirst) {
  const FloorPlan plan = Read("; a comment\n####\n#.o#\n#D.#\n####\n");
  EXPECT_EQ(plan.width(), 4);
  EXPECT_EQ(plan.height(), 4);
  EXPECT_EQ(plan.dock(), (Tile{1, 1}));
  EXPECT_EQ(plan.At({2, 2}), Surface::kFurniture);
  EXPECT_EQ(plan.At({1, 2}), Surface::kFloor);
  EXPECT_EQ(plan.At({-1, 0}), Surface::kWall);
}

TEST(FloorPlanTest, Mistakes_AreAllReportedWithTheirPlaces) {
  const std::string text = Complaints("####\n#x.#\n#..\n####\n");
  EXPECT_THAT(text, HasSubstr("plan.txt:2:2"));
  EXPECT_THAT(text, HasSubstr("plan.txt:3:1"));
  EXPECT_THAT(text, HasSubstr("one dock, 'D'; this one has 0"));
}

TEST(FloorPlanTest, TooSmallOrTooLarge_IsRefused) {
  EXPECT_THAT(Complaints(""), HasSubstr("3 to 400 rows"));
  EXPECT_THAT(Complaints("##\n##\n##\n"), HasSubstr("3 to 400 rows"));
  EXPECT_THAT(Complaints(std::string(401, '#') + "\n" + std::string(401, '#') + "\n###\n"),
              HasSubstr("3 to 400 rows"));
}

TEST(FloorPlanTest, FreeWay_EndsAtTheFirstObstacle) {
  const FloorPlan plan = Read(kRoom);
  const Point home = CentreOf(plan.dock());
  EXPECT_NEAR(plan.FreeWay(home, 0, 10), 13 * kTile - home.x, 1e-12);
  EXPECT_NEAR(plan.FreeWay(home, std::numbers::pi, 10), home.x - kTile, 1e-12);
  EXPECT_NEAR(plan.FreeWay(home, std::numbers::pi / 2, 10), 9 * kTile - home.y, 1e-12);
  EXPECT_EQ(plan.FreeWay(home, 0, 1), 1);
  const double diagonal = plan.FreeWay(home, std::numbers::pi / 4, 10);
  EXPECT_NEAR(diagonal, (9 * kTile - home.y) * std::sqrt(2), 1e-12);
}

TEST(FloorPlanTest, Sees_NotThroughAWall) {
  const FloorPlan plan = Read("#######\n#..#..#\n#D.#..#\n#.....#\n#######\n");
  EXPECT_FALSE(plan.Sees(CentreOf({1, 3}), CentreOf({5, 3})));
  EXPECT_TRUE(plan.Sees(CentreOf({1, 1}), CentreOf({5, 1})));
}

TEST(FloorPlanTest, Disc_TouchesExactly) {
  const FloorPlan plan = Read(kRoom);
  EXPECT_FALSE(plan.Touches({kTile + 0.3001, 1.0}, 0.3));
  EXPECT_TRUE(plan.Touches({kTile + 0.2999, 1.0}, 0.3));
}

TEST(ReachTest, OtherRoom_IsNotInReach) {
  const FloorPlan plan = Read(
      "###########\n"
      "#....#....#\n"
      "#....#....#\n"
      "#.D..#....#\n"
      "#....#....#\n"
      "###########\n");
  const auto reached = TilesInReach(plan, 0.3, 0.37);
  EXPECT_EQ(reached[plan.IndexOf({1, 1})], 1) << "the brush comes into corners";
  EXPECT_EQ(reached[plan.IndexOf({4, 4})], 1);
  EXPECT_EQ(reached[plan.IndexOf({7, 2})], 0);
  EXPECT_EQ(reached[plan.IndexOf({5, 2})], 0) << "a wall is no floor";
}

TEST(ReachTest, NarrowPassage_StopsAWideRobot) {
  const std::string_view text =
      "############\n"
      "#....oo....#\n"
      "#....oo....#\n"
      "#.D........#\n"
      "#..........#\n"
      "#....oo....#\n"
      "############\n";
  const FloorPlan plan = Read(text);
  const std::size_t beyond = plan.IndexOf({10, 3});
  EXPECT_EQ(TilesInReach(plan, 0.22, 0.3)[beyond], 1);
  EXPECT_EQ(TilesInReach(plan, 0.30, 0.3)[beyond], 0);
}

}  // namespace
}  // namespace latchwork::cleaning
