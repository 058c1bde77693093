// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/paths/find_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reasoners/ompl/paths/planner_table.h"
#include "tests/reasoners/ompl/small_maps.h"

namespace latchwork::planning {
namespace {

constexpr double kClearance = 0.35;
constexpr sdk::Budget kBudget{.inferences = 2'000'000};

class TwoRoomsTest : public ::testing::Test {
 protected:
  FoundPath Ask(const PathSettings& settings, const sdk::Budget& budget = kBudget) {
    Effort effort(budget);
    FoundPath found = FindPath(space_, {kLeft, {}}, kRight, settings, effort);
    spent_ = effort.spent();
    return found;
  }

  DistanceMap map_{TwoRooms()};
  FreeSpace space_{map_, kClearance};
  std::uint64_t spent_ = 0;
};

void ExpectLeadsOver(const Path& path, const FreeSpace& space) {
  ASSERT_GE(path.size(), 3U);
  EXPECT_EQ(path.front(), kLeft);
  EXPECT_EQ(path.back(), kRight);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_TRUE(space.IsFree(path[i - 1], path[i])) << "motion " << i;
  }
}

class PlannerTest : public TwoRoomsTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(PlannerTest, FindsTheDoorAndKeepsTheClearance) {
  const FoundPath found = Ask({.planner = GetParam(), .effort = 1'000'000});
  ASSERT_EQ(found.state, FoundPath::State::kFound) << "spent " << spent_;
  ExpectLeadsOver(found.path, space_);
  EXPECT_GT(Length(found.path), 8.0);
  EXPECT_LT(Length(found.path), 12.0);
}

TEST_P(PlannerTest, SameSeed_SamePathAndEffort) {
  const PathSettings settings{.planner = GetParam(), .effort = 1'000'000, .tries = 1};
  const FoundPath first = Ask(settings);
  const std::uint64_t spent = spent_;
  Ask({.planner = "RRT", .seed = 5});
  EXPECT_EQ(Ask(settings).path, first.path);
  EXPECT_EQ(spent_, spent);
}

TEST_P(PlannerTest, LittleBudget_NeverSpendsMoreAndSaysUnknown) {
  for (const SpaceKind kind :
       {SpaceKind::kPlane, SpaceKind::kPlaneAndHeading, SpaceKind::kReedsShepp}) {
    const FoundPath found = Ask({.planner = GetParam(), .space = kind}, {.inferences = 20});
    EXPECT_EQ(found.state, FoundPath::State::kUnknown);
    EXPECT_EQ(spent_, 20U);
  }
}

INSTANTIATE_TEST_SUITE_P(Planners, PlannerTest, ::testing::ValuesIn(PlannerNames()),
                         [](const auto& planner) { return planner.param; });

TEST_F(TwoRoomsTest, OtherSeed_OtherPath) {
  EXPECT_NE(Ask({.seed = 1, .tries = 1, .simplify = false}).path,
            Ask({.seed = 2, .tries = 1, .simplify = false}).path);
}

TEST_F(TwoRoomsTest, Simplified_Shorter) {
  const double raw = Length(Ask({.planner = "RRT", .tries = 1, .simplify = false}).path);
  EXPECT_LT(Length(Ask({.planner = "RRT", .tries = 1}).path), raw);
}

TEST_F(TwoRoomsTest, Optimized_SpendsItsEffortForAShorterPath) {
  const FoundPath first = Ask({.planner = "RRTstar", .tries = 1, .simplify = false});
  const std::uint64_t spent = spent_;
  const FoundPath best =
      Ask({.planner = "RRTstar", .tries = 1, .simplify = false, .optimize = true});
  EXPECT_GE(spent_, 100'000U);
  EXPECT_LT(spent, 100'000U);
  EXPECT_LT(Length(best.path), Length(first.path));
}

TEST_F(TwoRoomsTest, SpaceWithHeadings_FindsTheDoor) {
  for (const SpaceKind kind : {SpaceKind::kPlaneAndHeading, SpaceKind::kReedsShepp}) {
    const FoundPath found = Ask({.space = kind, .effort = 500'000});
    ASSERT_EQ(found.state, FoundPath::State::kFound);
    EXPECT_EQ(found.path.front(), kLeft);
    EXPECT_EQ(found.path.back(), kRight);
    for (const Point& corner : found.path) {
      EXPECT_GT(map_.Clearance(corner), kClearance - map_.resolution());
    }
  }
}

/// From the first corner to the second, or the other way round: the nearer to `heading`.
double TurnedFrom(double heading, const Path& path) {
  const double bearing = std::atan2(path[1].y - path[0].y, path[1].x - path[0].x);
  return std::abs(std::remainder(bearing - heading, std::numbers::pi));
}

TEST_F(TwoRoomsTest, Car_StartsAsItStands) {
  for (const double heading : {-2.9, -0.6, 0.2, 1.2}) {
    Effort effort(kBudget);
    const PathSettings settings{.space = SpaceKind::kReedsShepp, .effort = 500'000, .tries = 1};
    const FoundPath found = FindPath(space_, {kLeft, heading}, kRight, settings, effort);
    ASSERT_EQ(found.state, FoundPath::State::kFound) << heading;
    EXPECT_LT(TurnedFrom(heading, found.path), 0.12) << "half a decimetre's turn of " << heading;
  }
}

TEST(FindPathTest, WalledIn_NoneForCertainWithoutAskingThePlanner) {
  const DistanceMap map(WalledIn());
  const FreeSpace space(map, kClearance);
  Effort effort(kBudget);
  EXPECT_EQ(FindPath(space, {kLeft, {}}, kRight, {}, effort).state, FoundPath::State::kNone);
  EXPECT_EQ(effort.spent(), 0U);
}

TEST(FindPathTest, DoorTooNarrowForTheClearance_None) {
  const DistanceMap map(TwoRooms());
  const FreeSpace space(map, 0.8);
  Effort effort(kBudget);
  EXPECT_EQ(FindPath(space, {kLeft, {}}, kRight, {}, effort).state, FoundPath::State::kNone);
}

TEST(FindPathTest, ShutDoor_None) {
  const DistanceMap map(TwoRooms());
  const FreeSpace space(map, kClearance, {{{4.0, 4.75}, 0.6}});
  Effort effort(kBudget);
  EXPECT_EQ(FindPath(space, {kLeft, {}}, kRight, {}, effort).state, FoundPath::State::kNone);
}

TEST(FindPathTest, StartTooNearToAWall_MovedAndKept) {
  const DistanceMap map(TwoRooms());
  const FreeSpace space(map, kClearance);
  Effort effort(kBudget);
  const Point start{0.7, 3.0};
  const FoundPath found = FindPath(space, {start, {}}, {3.0, 1.0}, {}, effort);
  ASSERT_EQ(found.state, FoundPath::State::kFound);
  EXPECT_EQ(found.path.front(), start);
  EXPECT_LT(Distance(found.path[1], start), 0.3);
}

TEST(FindPathTest, GoalInAWall_None) {
  const DistanceMap map(Drawn({"#######", "#.....#", "#.....#", "#.....#", "#######"}, 40));
  const FreeSpace space(map, kClearance);
  Effort effort(kBudget);
  EXPECT_EQ(FindPath(space, {{3.0, 3.0}, {}}, {0.1, 5.0}, {}, effort).state,
            FoundPath::State::kNone);
}

TEST(FreeSpaceTest, ThinWall_IsNotCutByAnyMotion) {
  const DistanceMap map(WalledIn());
  const FreeSpace space(map, 0.05);
  for (double y = 0.7; y < 5.4; y += 0.01) {
    EXPECT_FALSE(space.IsFree({3.0, y}, {5.0, 6.0 - y})) << y;
  }
}

TEST(PlannerOptionsTest, MistakesAreNamedAllAtOnce) {
  logic::Diagnostics diagnostics;
  const auto options = ReadPlannerOptions("range=2 rang=3 range=-1 intermediate_states=yes range",
                                          "RRTConnect", {"a.xml", 3, 5}, diagnostics);
  EXPECT_EQ(options, (PlannerOptions{{"range", "2"}}));
  ASSERT_EQ(diagnostics.size(), 4U);
  EXPECT_EQ(diagnostics[0].message, "RRTConnect has no option 'rang'");
  EXPECT_EQ(diagnostics[0].hint, "it has intermediate_states, range");
  EXPECT_EQ(diagnostics[0].place.line, 3U);
}

TEST_F(TwoRoomsTest, Option_ReachesThePlanner) {
  const PathSettings near{
      .planner = "RRT", .options = {{"range", "0.2"}}, .tries = 1, .simplify = false};
  PathSettings far = near;
  far.options = {{"range", "3"}};
  EXPECT_GT(Ask(near).path.size(), 2 * Ask(far).path.size());
}

}  // namespace
}  // namespace latchwork::planning
