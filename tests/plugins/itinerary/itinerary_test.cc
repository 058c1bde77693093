// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// a - b - c - f1 on floor 1, a ring a - x - y - z - f1 the long way round; f2 - t on floor 2.
std::vector<std::string> Building() {
  std::vector<std::string> facts{"elevator_front(e1, f1, 1)",
                                 "elevator_front(e1, f2, 2)",
                                 "elevator_front(e2, z, 1)",
                                 "elevator_front(e2, t, 2)",
                                 "cab(e1, c1)",
                                 "cab(e2, c2)"};
  const std::vector<std::pair<std::string, std::string>> ways{{"a", "b"},  {"b", "c"}, {"c", "f1"},
                                                              {"a", "x"},  {"x", "y"}, {"y", "z"},
                                                              {"z", "f1"}, {"f2", "t"}};
  for (const auto& [p, q] : ways) {
    facts.push_back("adjacent(" + p + ", " + q + ")");
    facts.push_back("adjacent(" + q + ", " + p + ")");
  }
  return facts;
}

class ItineraryTest : public ::testing::TestWithParam<const char*> {
 protected:
  ItineraryTest() { mind_.Latch("building", Building()); }

  std::vector<std::string> NextFrom(const std::string& place, const std::string& goal) {
    mind_.Latch("place", {"curr_landmark(" + place + ")"});
    mind_.Latch("goal", {"goal(" + goal + ")"});
    return mind_.Decide();
  }
  LayerMind mind_{"itinerary", {}, GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Reasoners, ItineraryTest,
                         ::testing::Values("pttp", "circumscription", "icarus"), ReasonerName);

TEST_P(ItineraryTest, NoGoal_Silent) {
  mind_.Latch("place", {"curr_landmark(a)"});
  EXPECT_THAT(mind_.Decide(), IsEmpty());
}

TEST_P(ItineraryTest, SameFloor_FirstLandmarkOfTheShortestWay) {
  EXPECT_THAT(NextFrom("a", "f1"), ElementsAre("target_landmark(b)"));
  EXPECT_THAT(NextFrom("y", "f1"), ElementsAre("target_landmark(z)"));
}

TEST_P(ItineraryTest, AtTheGoal_StaysThere) {
  EXPECT_THAT(NextFrom("a", "a"), ElementsAre("target_landmark(a)"));
}

TEST_P(ItineraryTest, OtherFloor_TheOtherEndOfTheRide) {
  EXPECT_THAT(NextFrom("f1", "f2"), ElementsAre("target_landmark(f2)"));
  EXPECT_THAT(NextFrom("c", "f2"), ElementsAre("target_landmark(f1)"));
}

TEST_P(ItineraryTest, ShutDoor_TheOtherWayRoundAndBack) {
  mind_.Latch("doors", {"door_shut(c)"});
  EXPECT_THAT(NextFrom("a", "f1"), ElementsAre("target_landmark(x)"));
  mind_.Latch("doors", {});
  EXPECT_THAT(NextFrom("a", "f1"), ElementsAre("target_landmark(b)"));
}

TEST_P(ItineraryTest, ElevatorOutOfOrder_TheOtherElevator) {
  mind_.Latch("elevators", {"elevator_out_of_order(e1)"});
  EXPECT_THAT(NextFrom("c", "f2"), ElementsAre("target_landmark(f1)"));
  EXPECT_THAT(NextFrom("f1", "f2"), ElementsAre("target_landmark(z)"));
}

TEST_P(ItineraryTest, InTheCab_TheFloorOfTheGoal) {
  EXPECT_THAT(NextFrom("c1", "t"), ElementsAre("target_landmark(f2)"));
}

TEST_P(ItineraryTest, InAFailedCab_OutWhereItStands) {
  mind_.Latch("elevators", {"elevator_at(e1, 1)", "elevator_out_of_order(e1)"});
  EXPECT_THAT(NextFrom("c1", "t"), ElementsAre("target_landmark(f1)"));
}

TEST_P(ItineraryTest, NoWay_Silent) {
  mind_.Latch("doors", {"door_shut(b)", "door_shut(x)"});
  EXPECT_THAT(NextFrom("a", "f1"), IsEmpty());
}

}  // namespace
}  // namespace latchwork::test
