// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/temporary_folder.h"
#include "tests/worlds/office/office_fixture.h"

namespace latchwork::office {
namespace {

using logic::Fact;
using logic::Term;
using test::TemporaryFolder;
using testing::HasSubstr;

using OfficeWorldTest = OfficeFixture;

TEST_F(OfficeWorldTest, ShippedBuilding_LoadsAndItsLinesAreFree) {
  const auto wrong = Load({});
  ASSERT_TRUE(wrong.empty()) << logic::Format(wrong);
  const Building& building = world_.state().building;
  EXPECT_EQ(building.floors.size(), 3U);
  EXPECT_GE(building.rooms.size(), 60U);
  for (const Edge& edge : building.edges) {
    const Landmark& a = building.landmarks[edge.a];
    const Landmark& b = building.landmarks[edge.b];
    const FloorMap& map = building.floors[static_cast<std::size_t>(a.floor)].map;
    EXPECT_TRUE(IsLineFree(map, a.place, b.place, 0.44)) << a.name.name() << b.name.name();
  }
}

TEST_F(OfficeWorldTest, Names_AreDeclaredOnce) {
  const auto expect_unique = [](std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  };
  std::vector<std::string> parameters;
  for (const auto& spec : world_.parameters()) parameters.push_back(spec.name);
  expect_unique(parameters);
  std::vector<std::string> ports;
  for (const auto& port : world_.contract().outputs) ports.push_back(port.name);
  expect_unique(ports);
}

TEST_F(OfficeWorldTest, EveryPort_SaysWhatItsContractNames) {
  ASSERT_TRUE(Load({{"start", "r1_07"}, {"goal", "r3_02"}}).empty());
  Tick({});
  EXPECT_THAT(Sensed(kSonar), HasSubstr("15"));
  EXPECT_THAT(Sensed(kPose), HasSubstr("curr_heading("));
  EXPECT_EQ(Sensed(kPlace), "curr_landmark(r1_07) ");
  EXPECT_THAT(Sensed(kPose), HasSubstr("curr_floor(1)"));
  EXPECT_THAT(Sensed(kElevators), HasSubstr("elevator_at(e2, "));
  EXPECT_EQ(Sensed(kGoal), "goal(r3_02) ");
  EXPECT_EQ(sensors_[kSonar].facts.size(), 16U);
  EXPECT_THAT(Sensed(kRobot), HasSubstr("sonar_direction(0, 0.0) "));
  EXPECT_THAT(Sensed(kRobot), HasSubstr("robot_radius(0.25)"));
  for (const char* fact : {"landmark(cab_e1, 0, 18.0, 12.5)", "elevator_front(e2, l3_e2, 3)",
                           "cab(e1, cab_e1)", "adjacent(d1_08, i1_08)", "adjacent(i1_08, d1_08)"}) {
    EXPECT_THAT(Sensed(kBuilding), HasSubstr(fact));
  }
}

TEST_F(OfficeWorldTest, ElevatorRide_ChangesTheFloor) {
  ASSERT_TRUE(Load({{"start", "l1_e1"}, {"goal", "l3_e1"}, {"elevator_calls", "0"}}).empty());
  const auto open = [&] {
    const Elevator& e = world_.state().elevators[0];
    return e.floor() == world_.state().floor && e.door() == Elevator::Door::kOpen;
  };
  for (int i = 0; i < 900 && !open(); ++i) {
    Tick({}, {Make("call", {Word("e1"), Term::Integer(1)})});
  }
  ASSERT_TRUE(open());
  ASSERT_TRUE(DriveTo(PlaceOf("cab_e1")));
  EXPECT_THAT(Sensed(kPlace), HasSubstr("cab_e1"));
  for (int i = 0; i < 900 && !(open() && world_.state().floor == 2); ++i) {
    Tick({}, {Make("ride", {Word("e1"), Term::Integer(3)})});
  }
  EXPECT_EQ(world_.state().floor, 2);
  DriveTo(PlaceOf("l3_e1"));
  EXPECT_EQ(world_.outcome().state, sdk::Outcome::State::kReached);
  EXPECT_EQ(world_.outcome().message, "reached l3_e1");
}

TEST_F(OfficeWorldTest, DrivingIntoAShutDoor_IsACollision) {
  ASSERT_TRUE(Load({{"start", "c1_08"}, {"shut", "d1_08"}, {"start_heading", "0"}}).empty());
  EXPECT_FALSE(DriveTo(PlaceOf("i1_08")));
  EXPECT_EQ(world_.outcome().state, sdk::Outcome::State::kFailed);
  EXPECT_EQ(world_.Measures()[0].second, 1.0);
  EXPECT_THAT(Sensed(kDoors), HasSubstr("door_shut(d1_08)"));
}

TEST_F(OfficeWorldTest, Halt_OverridesForward) {
  ASSERT_TRUE(Load({{"start", "l1_mid"}}).empty());
  for (int i = 0; i < 10; ++i) Tick({Make("halt", {}), Make("fwd", {Term::Real(0.5)})});
  EXPECT_EQ(world_.state().vehicle->travelled(), 0.0);
}

TEST_F(OfficeWorldTest, NotANumber_IsIgnored) {
  ASSERT_TRUE(Load({{"start", "l1_mid"}}).empty());
  for (int i = 0; i < 10; ++i) Tick({Make("fwd", {Term::Real(std::nan(""))})});
  EXPECT_EQ(world_.state().vehicle->travelled(), 0.0);
}

TEST_F(OfficeWorldTest, SameSeed_SameRun_AnotherSeed_Another) {
  const auto run = [&](std::uint64_t seed) {
    EXPECT_TRUE(Load({{"boxes", "10"}, {"people", "8"}, {"sonar_noise", "0.05"}}, seed).empty());
    tick_ = 0;
    std::string text;
    for (int i = 0; i < 100; ++i) {
      Tick({Make("turn", {Term::Real(0.3)})});
      text += Sensed(kSonar) + Sensed(kPose) + Sensed(kElevators);
    }
    return text;
  };
  const std::string first = run(5);
  EXPECT_EQ(first, run(5));
  EXPECT_NE(first, run(6));
}

TEST_F(OfficeWorldTest, PeopleAndBoxes_NeverTouchAStandingRobotOrTheWays) {
  ASSERT_TRUE(Load({{"start", "xx"}}).size() == 1);
  ASSERT_TRUE(Load({{"start", "x1_s1"}, {"people", "40"}, {"boxes", "40"}}, 3).empty());
  const Building& building = world_.state().building;
  EXPECT_GE(world_.state().record.boxes.size(), 30U);
  for (const Edge& edge : building.edges) {
    const Landmark& a = building.landmarks[edge.a];
    const auto floor = static_cast<std::size_t>(a.floor);
    EXPECT_TRUE(
        IsLineFree(world_.state().maps[floor], a.place, building.landmarks[edge.b].place, 0.40));
  }
  for (int i = 0; i < 1500; ++i) {
    Tick({});
    for (const Disc& person : world_.state().people->On(0)) {
      const Point robot = PointOf(world_.state().vehicle->pose());
      ASSERT_GT(Distance(person.centre, robot), person.radius + 0.25);
    }
  }
}

/// A robot that stands where corridors cross is in the way whichever way people turn.
TEST_F(OfficeWorldTest, RobotInTheWay_PeopleGoSomeOtherWay) {
  ASSERT_TRUE(Load({{"start", "l1_s"}, {"people", "25"}}, 4).empty());
  const auto people = [&] { return world_.state().people->On(0); };
  std::vector<Point> places(people().size());
  std::vector<int> stood(people().size(), 0);
  int longest = 0;
  for (int i = 0; i < 6000; ++i) {
    Tick({});
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Point now = people()[k].centre;
      stood[k] = Distance(now, places[k]) > 0.0 ? 0 : stood[k] + 1;
      places[k] = now;
      longest = std::max(longest, stood[k]);
    }
  }
  EXPECT_GT(longest, 40) << "somebody had to wait";
  EXPECT_LT(longest, 600) << "and nobody for a minute";
}

TEST_F(OfficeWorldTest, Mistakes_AreReportedAllAtOnceWithPlaceAndHint) {
  const auto wrong = Load({{"start", "r1_7"}, {"goal", "r9_99"}, {"shut", "d1_08 dd"}});
  ASSERT_EQ(wrong.size(), 3U);
  EXPECT_EQ(wrong[0].place.line, 3U);
  const std::string text = logic::Format(wrong);
  EXPECT_THAT(text, HasSubstr("no door 'dd'"));
  EXPECT_THAT(text, HasSubstr("no landmark 'r1_7'"));
}

TEST_F(OfficeWorldTest, MalformedBuilding_NamesLines) {
  const TemporaryFolder folder;
  const auto file = folder.Write("b.p",
                                 "cnf(a, axiom, floor(1, 'none.png', 0.05)).\n"
                                 "cnf(b, axiom, landmrk(x, 1, 2.0, 3.0)).\n"
                                 "cnf(c, axiom, adjacent(x, y)).\n");
  const std::string text = logic::Format(Load({{"building", file.string()}}));
  EXPECT_THAT(text, HasSubstr("b.p:1:"));
  EXPECT_THAT(text, HasSubstr("no such file"));
  EXPECT_THAT(text, HasSubstr("did you mean 'landmark'?"));
  EXPECT_THAT(text, HasSubstr("b.p:3:"));
}

TEST_F(OfficeWorldTest, Events_ChangeTheWorldOrSayWhyNot) {
  ASSERT_TRUE(Load({{"start", "d1_08"}}).empty());
  EXPECT_TRUE(world_.HandleEvent(0, Make("door_shuts", {Word("d1_09")})).empty());
  EXPECT_TRUE(world_.state().doors[*world_.state().building.FindDoor("d1_09")].shut);
  EXPECT_TRUE(world_.HandleEvent(0, Make("door_opens", {Word("d1_09")})).empty());
  EXPECT_TRUE(world_.HandleEvent(0, Make("out_of_order", {Word("e2")})).empty());
  EXPECT_FALSE(world_.state().elevators[1].in_service());
  EXPECT_EQ(world_.HandleEvent(0, Make("door_shuts", {Word("nowhere")})).size(), 1U);
  EXPECT_EQ(world_.HandleEvent(0, Make("rain", {})).size(), 1U);
  EXPECT_EQ(world_.HandleEvent(0, Make("door_shuts", {Term::Integer(3)})).size(), 1U);
}

TEST_F(OfficeWorldTest, Pictures_AreDrawnForEveryFloor) {
  ASSERT_TRUE(Load({{"start", "l1_mid"}, {"boxes", "5"}, {"people", "5"}}).empty());
  DriveTo(PlaceOf("l1_s"));
  const TemporaryFolder folder;
  const auto files = world_.Draw(folder.path());
  ASSERT_EQ(files.size(), 7U);
  for (const auto& file : files) EXPECT_GT(std::filesystem::file_size(file), 2000U) << file;
  EXPECT_TRUE(world_.Draw("/nowhere/at/all").empty());
}

}  // namespace
}  // namespace latchwork::office
