// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/worlds/office/office_fixture.h"

namespace latchwork::office {
namespace {

using testing::HasSubstr;
using testing::Not;

using OfficeSensorsTest = OfficeFixture;

TEST_F(OfficeSensorsTest, FirstTick_UpdatesEveryPort_LaterOnlySonarAndPose) {
  ASSERT_TRUE(Load({{"start", "r1_07"}, {"goal", "r3_02"}, {"elevator_calls", "0"}}).empty());
  Tick({});
  for (std::size_t port = 0; port < kSensorPorts; ++port) EXPECT_TRUE(sensors_[port].updated);
  Tick({});
  for (std::size_t port = 0; port < kSensorPorts; ++port) {
    EXPECT_EQ(sensors_[port].updated, port == kSonar || port == kPose) << port;
  }
}

TEST_F(OfficeSensorsTest, ShutDoor_IsKnownFromAnywhereAndUntilItOpens) {
  ASSERT_TRUE(Load({{"start", "r1_07"}, {"shut", "d3_08"}}).empty());
  Tick({});
  EXPECT_EQ(Sensed(kDoors), "door_shut(d3_08) ");
  EXPECT_TRUE(world_.HandleEvent(1, Make("door_shuts", {Word("d2_04")})).empty());
  Tick({});
  EXPECT_TRUE(Updated(kDoors));
  EXPECT_EQ(Sensed(kDoors), "door_shut(d2_04) door_shut(d3_08) ");
  EXPECT_TRUE(world_.HandleEvent(2, Make("door_opens", {Word("d3_08")})).empty());
  Tick({});
  EXPECT_EQ(Sensed(kDoors), "door_shut(d2_04) ");
}

TEST_F(OfficeSensorsTest, ShutDoorEvent_WaitsForTheRobotToLeaveTheDoor) {
  ASSERT_TRUE(Load({{"start", "d1_08"}}).empty());
  ASSERT_TRUE(world_.HandleEvent(0, Make("door_shuts", {Word("d1_08")})).empty());
  for (int i = 0; i < 50; ++i) Tick({});
  EXPECT_EQ(Sensed(kDoors), "");
  ASSERT_TRUE(DriveTo(PlaceOf("i1_08")));
  Tick({});
  EXPECT_EQ(Sensed(kDoors), "door_shut(d1_08) ");
  EXPECT_EQ(world_.Measures()[0].second, 0.0);
}

TEST_F(OfficeSensorsTest, FailedSonar_HearsNothingUntilItRecovers) {
  ASSERT_TRUE(Load({{"start", "r1_07"}, {"sonar_missed", "0"}, {"sonar_range", "20"}}).empty());
  Tick({});
  EXPECT_THAT(Sensed(kSonar), HasSubstr("sonar_reading(3, "));
  ASSERT_TRUE(world_.HandleEvent(1, Make("sonar_fails", {Term::Integer(3)})).empty());
  Tick({});
  EXPECT_THAT(Sensed(kSonar), HasSubstr("no_echo(3)"));
  ASSERT_TRUE(world_.HandleEvent(2, Make("sonar_recovers", {Term::Integer(3)})).empty());
  Tick({});
  EXPECT_THAT(Sensed(kSonar), Not(HasSubstr("no_echo(3)")));
  EXPECT_EQ(world_.HandleEvent(3, Make("sonar_fails", {Term::Integer(16)})).size(), 1U);
}

TEST_F(OfficeSensorsTest, GoalChanges_IsSaidOnce) {
  ASSERT_TRUE(Load({{"start", "r1_07"}, {"goal", "r3_02"}}).empty());
  Tick({});
  ASSERT_TRUE(world_.HandleEvent(1, Make("goal_changes", {Word("r2_05")})).empty());
  Tick({});
  EXPECT_TRUE(Updated(kGoal));
  EXPECT_EQ(Sensed(kGoal), "goal(r2_05) ");
  Tick({});
  EXPECT_FALSE(Updated(kGoal));
  EXPECT_EQ(world_.HandleEvent(3, Make("goal_changes", {Word("nowhere")})).size(), 1U);
}

TEST_F(OfficeSensorsTest, OutOfOrder_IsSaid) {
  ASSERT_TRUE(Load({{"start", "r1_07"}, {"elevator_calls", "0"}}).empty());
  ASSERT_TRUE(world_.HandleEvent(0, Make("out_of_order", {Word("e2")})).empty());
  Tick({});
  EXPECT_THAT(Sensed(kElevators), HasSubstr("elevator_out_of_order(e2)"));
  EXPECT_THAT(Sensed(kElevators), Not(HasSubstr("elevator_open")));
}

TEST_F(OfficeSensorsTest, Destinations_AreFreeAndFarEnough_AndComeOneAfterTheOther) {
  ASSERT_TRUE(Load({{"start", "x1_s1"}, {"destinations", "random"}}).empty());
  const Point robot = world_.state().place();
  Tick({});
  std::string last = Sensed(kDestination);
  int changes = 0;
  for (int i = 0; i < 1830; ++i) {
    const Point place = *world_.state().destinations->current();
    EXPECT_FALSE(FindContact(world_.state().maps[0], place, 0.6));
    EXPECT_GE(Distance(place, robot), 2.0);
    EXPECT_LE(Distance(place, robot), 15.0);
    Tick({});
    EXPECT_EQ(Updated(kDestination), Sensed(kDestination) != last);
    changes += Updated(kDestination) ? 1 : 0;
    last = Sensed(kDestination);
  }
  EXPECT_EQ(changes, 3);  // one after each minute
  EXPECT_EQ(world_.state().destinations->reached(), 0U);
}

TEST_F(OfficeSensorsTest, DestinationReached_IsCounted) {
  ASSERT_TRUE(Load({{"start", "x1_s1"}, {"destinations", "random"}}).empty());
  const Point place = *world_.state().destinations->current();
  Destinations destinations(1, 0.25, 0.1);
  destinations.Update(world_.state().maps[0], world_.state().place());
  ASSERT_TRUE(destinations.current());
  EXPECT_EQ(destinations.current()->x, place.x);
  EXPECT_EQ(destinations.reached(), 0U);
  destinations.Update(world_.state().maps[0], place);
  EXPECT_EQ(destinations.reached(), 1U);
  EXPECT_GE(Distance(*destinations.current(), place), 2.0);
}

}  // namespace
}  // namespace latchwork::office
