// SPDX-License-Identifier: BSD-3-Clause
//
// The planner in the place of each layer, in the office building.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/reasoners/ompl/reasoner_mind.h"

namespace latchwork::planning {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using Facts = std::vector<std::string>;

const Facts kSeek{"object(o)", "distance(o, d)", "direction(o, a)"};
const Facts kItinerary{"target_landmark(l)"};
const Facts kElevators{"move_cmd(x, y)", "call(e, k)", "ride(e, k)"};

/// Two elevators, three floors, and what else there is.
Facts House(Facts more) {
  for (const std::string e : {"e1", "e2"}) {
    more.push_back("cab(" + e + ", cab_" + e + ")");
    for (const std::string k : {"1", "2", "3"}) {
      more.push_back("elevator_front(" + e + ", l" + k + "_" + e + ", " + k + ")");
    }
  }
  return more;
}

TEST(SeekJobTest, NoDestination_RefutedAndSilent) {
  ReasonerMind mind(kSeek);
  EXPECT_THAT(mind.Decide({"curr_location(10.0, 7.9)", "curr_heading(0.0)"}), IsEmpty());
  EXPECT_EQ(mind.decision().status, sdk::Status::kRefuted);
}

TEST(SeekJobTest, FreeWayAhead_PushedFromBehind) {
  ReasonerMind mind(kSeek, {}, {"push_distance(1.5)", "arrive_tolerance(0.2)"});
  EXPECT_THAT(mind.Decide({"curr_location(10.0, 7.9)", "curr_heading(0.0)", "curr_floor(1)",
                           "move_cmd(20.0, 7.9)"}),
              ElementsAre(StartsWith("direction(push_object, 3.14159"),
                          "distance(push_object, 1.5)", "object(push_object)"));
}

TEST(SeekJobTest, DestinationReached_Silent) {
  ReasonerMind mind(kSeek);
  EXPECT_THAT(mind.Decide({"curr_location(10.0, 7.9)", "curr_heading(0.0)", "move_cmd(10.1, 7.9)"}),
              IsEmpty());
}

/// The beeline from the room r1_01 to the corridor south-east of it leads through a wall; the door
/// is in the north-west.
TEST(SeekJobTest, WallInTheWay_PushedTowardsTheDoor) {
  ReasonerMind mind(kSeek);
  const Facts facts{"curr_location(3.6, 5.0)", "curr_heading(0.0)", "curr_floor(1)",
                    "move_cmd(9.0, 7.9)"};
  const Facts pushed = mind.Decide(facts);
  ASSERT_EQ(pushed.size(), 3U);
  EXPECT_THAT(pushed[0], StartsWith("direction(push_object, -"));
  const std::uint64_t planning = mind.decision().statistics.inferences;
  EXPECT_GT(planning, 20U);
  mind.Decide(facts);
  EXPECT_EQ(mind.decision().statistics.inferences, 0U) << "the path is kept";
}

TEST(SeekJobTest, Car_IsPushedAlongItsHeading) {
  for (const std::string heading : {"-2.0", "0.4", "1.2"}) {
    ReasonerMind mind(kSeek, {{"space", "reeds_shepp"}, {"lookahead", "0.3"}});
    const Facts pushed = mind.Decide({"curr_location(10.0, 7.9)", "curr_heading(" + heading + ")",
                                      "curr_floor(1)", "move_cmd(20.0, 7.9)"});
    ASSERT_EQ(pushed.size(), 3U);
    const double direction = std::stod(pushed[0].substr(pushed[0].find(' ')));
    EXPECT_LT(std::abs(std::remainder(direction, std::numbers::pi)), 0.35) << pushed[0];
  }
}

TEST(SeekJobTest, Sectors_RoundThePush) {
  ReasonerMind mind(kSeek, {}, {"sector_width(0.7853981633974483)"});
  EXPECT_THAT(mind.Decide({"curr_location(10.0, 7.9)", "curr_heading(0.3)", "curr_floor(1)",
                           "move_cmd(20.0, 7.9)"})[0],
              StartsWith("direction(push_object, 3.14159"));
}

TEST(SeekJobTest, FloorThatTheMapLacks_Failed) {
  ReasonerMind mind(kSeek);
  mind.Decide(
      {"curr_location(10.0, 7.9)", "curr_heading(0.3)", "curr_floor(9)", "move_cmd(20.0, 7.9)"});
  EXPECT_EQ(mind.decision().status, sdk::Status::kFailed);
  EXPECT_EQ(mind.decision().message, "the map has no floor 9");
}

TEST(ItineraryJobTest, SameFloor_NextLandmarkOnThePath) {
  ReasonerMind mind(kItinerary);
  EXPECT_THAT(mind.Decide(House({"curr_landmark(c1_09)", "goal(c1_13)", "adjacent(c1_09, c1_08)",
                                 "adjacent(c1_08, c1_13)", "adjacent(c1_09, c1_10)",
                                 "adjacent(c1_10, c1_04)", "adjacent(c1_04, c1_13)"})),
              ElementsAre("target_landmark(c1_10)"));
}

TEST(ItineraryJobTest, NoLandmarkOnThePath_OneBesideItThatLeadsThere) {
  ReasonerMind mind(kItinerary);
  EXPECT_THAT(mind.Decide(House({"curr_landmark(c1_09)", "goal(c1_13)", "adjacent(c1_09, c1_10)",
                                 "adjacent(c1_09, d1_02)", "adjacent(d1_02, c1_13)"})),
              ElementsAre("target_landmark(d1_02)"));
}

TEST(ItineraryJobTest, NoWalkOfLandmarks_TheGoal) {
  ReasonerMind mind(kItinerary);
  EXPECT_THAT(mind.Decide(House({"curr_landmark(c1_09)", "goal(c1_13)", "adjacent(c1_09, c1_10)"})),
              ElementsAre("target_landmark(c1_13)"));
}

TEST(ItineraryJobTest, Arrived_StaysThere) {
  ReasonerMind mind(kItinerary);
  EXPECT_THAT(mind.Decide(House({"curr_landmark(c1_09)", "goal(c1_09)"})),
              ElementsAre("target_landmark(c1_09)"));
}

TEST(ItineraryJobTest, OtherFloor_ByElevatorAndOnWhenOut) {
  ReasonerMind mind(kItinerary);
  EXPECT_THAT(mind.Decide(House({"curr_landmark(l1_e1)", "goal(c3_01)"})),
              ElementsAre("target_landmark(l3_e1)"));
  EXPECT_THAT(mind.Decide(House({"curr_landmark(cab_e1)", "goal(c3_01)"})),
              ElementsAre("target_landmark(l3_e1)"));
  EXPECT_EQ(mind.decision().statistics.inferences, 0U) << "the route is kept";
}

TEST(ItineraryJobTest, ElevatorOutOfOrder_TheOther) {
  ReasonerMind mind(kItinerary);
  EXPECT_THAT(
      mind.Decide(House({"curr_landmark(l1_e1)", "goal(l3_e1)", "elevator_out_of_order(e1)"})),
      ElementsAre("target_landmark(l1_e2)"));
}

TEST(ItineraryJobTest, BothOutOfOrder_RefutedForAnotherFloor) {
  ReasonerMind mind(kItinerary);
  EXPECT_THAT(mind.Decide(House({"curr_landmark(l1_e1)", "goal(l3_e1)", "elevator_out_of_order(e1)",
                                 "elevator_out_of_order(e2)"})),
              IsEmpty());
  EXPECT_EQ(mind.decision().status, sdk::Status::kRefuted);
}

TEST(ItineraryJobTest, InACabOutOfOrder_OutWhereItIs) {
  ReasonerMind mind(kItinerary);
  EXPECT_THAT(mind.Decide(House({"curr_landmark(cab_e1)", "goal(l3_e2)", "elevator_at(e1, 2)",
                                 "elevator_out_of_order(e1)"})),
              ElementsAre("target_landmark(l2_e1)"));
}

/// The only door of r1_01 is d1_01.
TEST(ItineraryJobTest, ElevatorFailsOnTheWay_OutWhereItStops) {
  ReasonerMind mind(kItinerary);
  Facts facts{"curr_landmark(cab_e1)", "goal(c3_01)", "elevator_at(e1, 1)"};
  EXPECT_THAT(mind.Decide(House(facts)), ElementsAre("target_landmark(l3_e1)"));
  facts.push_back("elevator_out_of_order(e1)");
  EXPECT_THAT(mind.Decide(House(facts)), ElementsAre("target_landmark(l1_e1)"));
  facts[2] = "elevator_at(e1, 2)";
  EXPECT_THAT(mind.Decide(House(facts)), ElementsAre("target_landmark(l2_e1)"));
}

TEST(ItineraryJobTest, RoomBehindAShutDoor_Refuted) {
  ReasonerMind mind(kItinerary);
  EXPECT_THAT(mind.Decide(House({"curr_landmark(c1_09)", "goal(r1_01)", "door_shut(d1_01)"})),
              IsEmpty());
  EXPECT_EQ(mind.decision().status, sdk::Status::kRefuted);
  EXPECT_THAT(mind.Decide(House({"curr_landmark(c1_09)", "goal(r1_01)"})),
              ElementsAre("target_landmark(r1_01)"));
}

TEST(ItineraryJobTest, BudgetTooSmall_Unknown) {
  ReasonerMind mind(kItinerary);
  mind.budget().inferences = 15;
  EXPECT_THAT(mind.Decide(House({"curr_landmark(r1_03)", "goal(r1_25)"})), IsEmpty());
  EXPECT_EQ(mind.decision().status, sdk::Status::kUnknown);
  EXPECT_EQ(mind.decision().limit, sdk::Limit::kInferences);
}

TEST(ItineraryJobTest, LandmarkThatTheMapLacks_Failed) {
  ReasonerMind mind(kItinerary);
  mind.Decide(House({"curr_landmark(nowhere)", "goal(r1_25)"}));
  EXPECT_EQ(mind.decision().status, sdk::Status::kFailed);
  EXPECT_EQ(mind.decision().message, "the map has no landmark 'nowhere'");
}

TEST(ElevatorsJobTest, TargetNextDoor_ItsCoordinates) {
  ReasonerMind mind(kElevators);
  EXPECT_THAT(mind.Decide(House(
                  {"curr_landmark(c1_09)", "target_landmark(c1_10)", "adjacent(c1_09, c1_10)"})),
              ElementsAre("move_cmd(15.45, 7.9)"));
}

TEST(ElevatorsJobTest, WholeRide_CallBoardRideLeave) {
  ReasonerMind mind(kElevators);
  const std::string target = "target_landmark(l3_e1)";
  EXPECT_THAT(mind.Decide(House({"curr_landmark(l1_e1)", target, "elevator_at(e1, 2)"})),
              ElementsAre("call(e1, 1)", StartsWith("move_cmd(20.")));
  EXPECT_THAT(mind.Decide(House({"curr_landmark(l1_e1)", target, "elevator_at(e1, 1)"})),
              ElementsAre("call(e1, 1)", StartsWith("move_cmd(20.")));
  EXPECT_THAT(mind.Decide(House(
                  {"curr_landmark(l1_e1)", target, "elevator_at(e1, 1)", "elevator_open(e1)"})),
              ElementsAre("move_cmd(18.0, 12.5)"));
  EXPECT_THAT(mind.Decide(House({"curr_landmark(cab_e1)", target, "inside(e1)",
                                 "elevator_at(e1, 1)", "elevator_open(e1)"})),
              ElementsAre("move_cmd(18.0, 12.5)", "ride(e1, 3)"));
  EXPECT_THAT(
      mind.Decide(House({"curr_landmark(cab_e1)", target, "inside(e1)", "elevator_at(e1, 3)"})),
      ElementsAre("move_cmd(18.0, 12.5)"));
  EXPECT_THAT(mind.Decide(House({"curr_landmark(cab_e1)", target, "inside(e1)",
                                 "elevator_at(e1, 3)", "elevator_open(e1)"})),
              ElementsAre(StartsWith("move_cmd(20.")));
}

TEST(OmplReasonerTest, MapThatIsNotThere_NamedWithItsPlace) {
  const ReasonerMind mind(kSeek, {{"map", "nowhere.png"}});
  ASSERT_EQ(mind.diagnostics().size(), 1U);
  EXPECT_THAT(mind.diagnostics()[0].message, HasSubstr("nowhere.png"));
  EXPECT_EQ(mind.diagnostics()[0].place.line, 7U);
}

TEST(OmplReasonerTest, BadParameters_AllAtOnce) {
  const ReasonerMind mind(kSeek, {{"map", "a.gif"}, {"options", "rang=2 goal_bias=7"}});
  ASSERT_EQ(mind.diagnostics().size(), 3U);
  EXPECT_EQ(mind.diagnostics()[0].message, "RRTConnect has no option 'rang'");
  EXPECT_THAT(mind.diagnostics()[2].message, HasSubstr("not a map for planners"));
}

TEST(OmplReasonerTest, PlannerThatIsNone_NearestNamed) {
  const ReasonerMind mind(kSeek, {{"planner", "RRTConect"}});
  ASSERT_EQ(mind.diagnostics().size(), 1U);
  EXPECT_THAT(logic::Format(mind.diagnostics()), HasSubstr("RRTConnect"));
}

TEST(OmplReasonerTest, LayerOfAnotherKind_Refused) {
  const ReasonerMind mind({"halt"});
  ASSERT_EQ(mind.diagnostics().size(), 1U);
  EXPECT_THAT(mind.diagnostics()[0].message, HasSubstr("does not know what this layer is for"));
}

}  // namespace
}  // namespace latchwork::planning
