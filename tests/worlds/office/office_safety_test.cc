// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/worlds/office/office_fixture.h"

namespace latchwork::office {
namespace {

class OfficeSafetyTest : public OfficeFixture, public testing::WithParamInterface<std::uint64_t> {
 protected:
  /// The shortest of the sonars ahead and next to it, m.
  double GapAhead() const {
    double gap = std::numeric_limits<double>::infinity();
    for (const Fact& fact : sensors_[kSonar].facts) {
      if (fact.arity() != 2) continue;
      const auto number = fact.argument(0).integer();
      const bool ahead = number <= 3 || number >= 13;
      if (ahead) gap = std::min(gap, fact.argument(1).number());
    }
    return gap;
  }

  /// Nobody who is within 0.9 m of the robot's rim has come nearer by his own step.
  void ExpectNobodyComesNearer(const std::vector<Disc>& before, Point robot) {
    const auto now = world_.state().people->On(world_.state().floor);
    ASSERT_EQ(before.size(), now.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double gap = Distance(now[i].centre, robot) - now[i].radius - 0.25;
      const double gap_before = Distance(before[i].centre, robot) - now[i].radius - 0.25;
      EXPECT_TRUE(gap >= 0.9 || gap >= gap_before) << gap;
    }
  }

  std::vector<Disc> PeopleNow() const {
    const auto now = world_.state().people->On(world_.state().floor);
    return {now.begin(), now.end()};
  }
};

TEST_P(OfficeSafetyTest, StandingRobot_IsNeverTouched) {
  ASSERT_TRUE(Load({{"start", "x1_s1"}, {"people", "10"}}, GetParam()).empty());
  const Point robot = world_.state().place();
  for (int i = 0; i < 1200; ++i) {
    const std::vector<Disc> before = PeopleNow();
    Tick({});
    ExpectNobodyComesNearer(before, robot);
  }
  EXPECT_EQ(world_.outcome().state, sdk::Outcome::State::kRunning);
}

TEST_P(OfficeSafetyTest, RobotThatBrakesForWhatIsAhead_NeverCollides) {
  ASSERT_TRUE(
      Load({{"start", "x1_s1"}, {"people", "10"}, {"drive_for", "120"}, {"sonar_missed", "0"}},
           GetParam())
          .empty());
  for (int i = 0; i < 1200; ++i) {
    const std::vector<Disc> before = PeopleNow();
    const Point robot = world_.state().place();
    if (GapAhead() > 0.5) {
      Tick({Make("fwd", {Term::Real(0.6)})});
    } else {
      Tick({Make("halt", {}), Make("turn", {Term::Real(0.7)})});
    }
    ExpectNobodyComesNearer(before, robot);
  }
  EXPECT_EQ(world_.outcome().message, "drove for 120 s without a collision");
  EXPECT_EQ(world_.outcome().state, sdk::Outcome::State::kReached);
}

INSTANTIATE_TEST_SUITE_P(Seeds, OfficeSafetyTest, testing::Values(1, 2, 3, 4, 5, 6));

using OfficeElevatorTest = OfficeFixture;

TEST_F(OfficeElevatorTest, OpenDoor_LetsTheRobotInWithMargin) {
  ASSERT_TRUE(Load({{"start", "l1_e1"}, {"elevator_floors", "1 2"}}).empty());
  for (int i = 0; i < 30; ++i) Tick({}, {Make("call", {Word("e1"), Term::Integer(1)})});
  ASSERT_EQ(world_.state().elevators[0].door(), Elevator::Door::kOpen);
  EXPECT_TRUE(IsLineFree(world_.state().maps[0], PlaceOf("l1_e1"), PlaceOf("cab_e1"), 0.45));
}

TEST_F(OfficeElevatorTest, RobotInTheDoor_KeepsItOpen) {
  ASSERT_TRUE(
      Load({{"start", "l1_e1"}, {"elevator_floors", "1 2"}, {"elevator_calls", "0"}}).empty());
  for (int i = 0; i < 30; ++i) Tick({}, {Make("call", {Word("e1"), Term::Integer(1)})});
  ASSERT_TRUE(DriveTo({19.1, 12.5}));
  for (int i = 0; i < 600; ++i) {
    Tick({});
    ASSERT_FALSE(world_.state().elevators[0].is_shut());
  }
}

TEST_F(OfficeElevatorTest, RobotThatEntersAtAnyMomentOfClosing_IsNotCaught) {
  for (int wait = 60; wait < 85; ++wait) {
    ASSERT_TRUE(
        Load({{"start", "l1_e1"}, {"elevator_floors", "1 2"}, {"elevator_calls", "0"}}).empty());
    for (int i = 0; i < 25; ++i) Tick({}, {Make("call", {Word("e1"), Term::Integer(1)})});
    const Pose start = world_.state().vehicle->pose();
    Tick({Make("turn", {Term::Real(WrapAngle(std::numbers::pi - start.heading))})});
    const int begin = wait;
    for (int i = 0; i < begin; ++i) {
      std::vector<sdk::Batch> held(kEffectorPorts);
      held[kDrive].facts = {
          Make("turn", {Term::Real(WrapAngle(std::numbers::pi - start.heading))})};
      world_.Observe(tick_, sensors_);
      world_.Apply(tick_, held);
      world_.Step(tick_++);
    }
    // It brakes only for what its sonar tells: a door that has shut.
    for (int i = 0; i < 60 && world_.state().place().x > 18.0; ++i) {
      double gap = 9.0;
      for (const Fact& fact : sensors_[kSonar].facts) {
        if (fact.arity() == 2 && fact.argument(0).integer() == 0) gap = fact.argument(1).number();
      }
      Tick({Make("fwd", {Term::Real(gap > 0.4 ? 0.6 : 0.0)})});
    }
    ASSERT_EQ(world_.Measures()[0].second, 0.0) << wait << ": " << world_.outcome().message;
  }
}

TEST_F(OfficeElevatorTest, ButtonPressedInEveryTick_IsTheSameAsOnce) {
  const auto ticks_until_open = [&](bool again) {
    EXPECT_TRUE(
        Load({{"start", "l1_e1"}, {"elevator_floors", "3 2"}, {"elevator_calls", "0"}}).empty());
    int ticks = 0;
    while (ticks < 2000 && world_.state().elevators[0].is_shut()) {
      const bool press = again || ticks == 0;
      Tick({},
           press ? std::vector{Make("call", {Word("e1"), Term::Integer(1)})} : std::vector<Fact>{});
      ++ticks;
    }
    return ticks;
  };
  const int once = ticks_until_open(false);
  EXPECT_LT(once, 2000);
  EXPECT_EQ(once, ticks_until_open(true));
}

using OfficeDriveTest = OfficeFixture;

TEST_F(OfficeDriveTest, TurnThatStands_CountsFromTheHeadingWhereItWasTold) {
  ASSERT_TRUE(Load({{"start", "l1_mid"}, {"start_heading", "0"}}).empty());
  std::vector<sdk::Batch> effectors(kEffectorPorts);
  effectors[kDrive] = {true, {Make("turn", {Term::Real(1.0)})}};
  for (int i = 0; i < 40; ++i) {
    world_.Observe(tick_, sensors_);
    world_.Apply(tick_, effectors);
    world_.Step(tick_++);
    effectors[kDrive].updated = false;
  }
  EXPECT_NEAR(world_.state().vehicle->pose().heading, 1.0, 0.01);
}

TEST_F(OfficeDriveTest, DriveForWithCollisions_Fails) {
  ASSERT_TRUE(
      Load({{"start", "l1_mid"}, {"drive_for", "60"}, {"end_at_collision", "false"}}).empty());
  for (int i = 0; i < 600; ++i) Tick({Make("fwd", {Term::Real(0.6)})});
  EXPECT_EQ(world_.outcome().state, sdk::Outcome::State::kFailed);
  EXPECT_EQ(world_.Measures()[1], (std::pair<std::string, double>("time_s", 60.0)));
}

}  // namespace
}  // namespace latchwork::office
