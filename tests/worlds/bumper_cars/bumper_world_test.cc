// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/bumper_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/temporary_folder.h"
#include "worlds/bumper_cars/bumper_contract.h"

namespace latchwork::bumper_cars {
namespace {

using logic::Fact;
using logic::Term;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;
using State = sdk::Outcome::State;

class BumperWorldTest : public ::testing::Test {
 protected:
  logic::Diagnostics Load(const std::vector<std::pair<std::string, std::string>>& values,
                          std::uint64_t seed = 1) {
    std::vector<sdk::Parameters::Given> given;
    for (const auto& [name, value] : values) given.push_back({name, value, {"agent.xml", 3, 5}});
    logic::Diagnostics diagnostics;
    const auto parameters = sdk::Parameters::Check(world_.parameters(), given, "bumper_cars",
                                                   {"agent.xml", 2, 1}, diagnostics);
    if (!diagnostics.empty()) return diagnostics;
    tick_ = 0;
    return world_.Load({seed, 0.1, {}, &symbols_}, parameters);
  }

  /// Only the agent and, ahead of it, one car that does not drive.
  void LoadTwo(const std::string& whom,
               std::vector<std::pair<std::string, std::string>> more = {}) {
    for (const char* group : {"enemies", "friends", "strangers"}) {
      more.emplace_back(group, group == whom ? "1" : "0");
    }
    if (whom != "enemies") more.emplace_back("rams", "0");
    if (whom == "friends") more.emplace_back("taps", "1");
    ASSERT_THAT(Load(more), IsEmpty());
    arena().cars[0].place = {5, 5};
    arena().cars[1].place = {8, 5};
    arena().cars[1].heading = 0;
    arena().cars[1].stalled = true;
    arena().poles.clear();
  }

  void Tick(double pedal, const std::string& at_gate = {}, int count = 1) {
    std::vector<sdk::Batch> effectors(kEffectorPorts);
    effectors[kDrive].facts = {Fact(symbols_.Intern("pedal"), {Term::Real(pedal)}),
                               Fact(symbols_.Intern("steer"), {Term::Integer(0)})};
    if (!at_gate.empty()) effectors[kGate].facts = {Fact(symbols_.Intern(at_gate))};
    for (int i = 0; i < count; ++i) {
      world_.Observe(tick_, sensors_);
      world_.Apply(tick_, effectors);
      world_.Step(tick_++);
    }
  }

  std::string Sensed(SensorPort port) {
    world_.Observe(tick_, sensors_);
    std::string text;
    for (const Fact& fact : sensors_[port].facts) text += logic::ToString(fact) + " ";
    return text;
  }

  logic::Diagnostics Event(const std::string& name, const std::string& car) {
    return world_.HandleEvent(tick_,
                              Fact(symbols_.Intern(name), {Term::Constant(symbols_.Intern(car))}));
  }
  Arena& arena() { return world_.arena(); }

  logic::SymbolTable symbols_;
  BumperWorld world_;
  std::vector<sdk::Batch> sensors_ = std::vector<sdk::Batch>(kSensorPorts);
  std::uint64_t tick_ = 0;
};

TEST_F(BumperWorldTest, FirstTick_SaysTaskPlacesAndPeople) {
  ASSERT_THAT(Load({{"enemies", "1"}, {"friends", "1"}, {"strangers", "1"}}), IsEmpty());
  EXPECT_EQ(Sensed(kTask), "task(collision) today(monday) spills_wanted(3) thrills_wanted(5) ");
  EXPECT_EQ(Sensed(kPlaces),
            "arena(16.0, 10.0) pole(pole1, 4.8, 2.5) pole(pole2, 11.2, 7.5) "
            "gate(1.2, 5.0) ");
  EXPECT_EQ(Sensed(kPeople),
            "driver(car1, anna) enemy(anna) driver(car2, bob) friend(bob) "
            "driver(car3, carl) ");
  EXPECT_EQ(Sensed(kSelf), "pose(1.2, 5.0, 0.0) speed(0.0) power(on) ");
}

TEST_F(BumperWorldTest, EyesSeeWhatIsInTheFieldOfView) {
  LoadTwo("enemies", {{"sight_noise", "0"}, {"field_of_view", "180"}});
  EXPECT_EQ(Sensed(kEyes), "sees(car1, 3.0, 0.0) ");
  arena().cars[1].place = {5, 6.5};
  EXPECT_THAT(Sensed(kEyes), StartsWith("sees(car1, 1.5, 1.57"));
  arena().cars[1].place = {4, 5};
  EXPECT_EQ(Sensed(kEyes), "");
}

TEST_F(BumperWorldTest, EnemyHitFast_IsRammed) {
  LoadTwo("enemies");
  Tick(100, "", 40);
  EXPECT_EQ(world_.outcome().state, State::kReached);
  EXPECT_EQ(world_.outcome().message, "rammed 1 enemies and tapped 0 friends");
  EXPECT_THAT(Sensed(kScore), HasSubstr("rammed(car1) spill_count(1)"));
}

TEST_F(BumperWorldTest, EnemyHitSlowly_IsNot) {
  LoadTwo("enemies");
  Tick(30, "", 80);
  EXPECT_EQ(world_.outcome().state, State::kRunning);
  EXPECT_THAT(Sensed(kScore), Not(HasSubstr("rammed")));
  EXPECT_GT(world_.Measures()[2].second, 0);  // bumps
  arena().cars[1].place = arena().cars[0].place + Vector{2 * kCarRadius, 0};
  EXPECT_EQ(Sensed(kTouchPort), "touching(car1) ");
}

TEST_F(BumperWorldTest, FriendHitSlowly_IsTapped) {
  LoadTwo("friends");
  Tick(20, "", 80);
  EXPECT_EQ(world_.outcome().state, State::kReached);
}

TEST_F(BumperWorldTest, FriendHitFast_Fails) {
  LoadTwo("friends");
  Tick(100, "", 40);
  EXPECT_EQ(world_.outcome().state, State::kFailed);
  EXPECT_THAT(world_.outcome().message, StartsWith("hit anna, a friend, at "));
}

TEST_F(BumperWorldTest, BeingHitByAFriend_IsNobodysFault) {
  LoadTwo("friends");
  arena().cars[1].place = {6.2, 5};
  arena().cars[1].velocity = {-2, 0};
  Tick(0, "", 30);
  EXPECT_EQ(world_.outcome().state, State::kRunning);
  EXPECT_LT(arena().cars[0].place.x, 5);
}

TEST_F(BumperWorldTest, PushedIntoAFriend_IsNobodysFault) {
  ASSERT_THAT(
      Load({{"enemies", "0"}, {"friends", "1"}, {"strangers", "1"}, {"rams", "0"}, {"taps", "1"}}),
      IsEmpty());
  arena().poles.clear();
  for (Car& car : arena().cars) {
    car.heading = 0;
    car.stalled = true;
  }
  arena().cars[0].place = {5, 5};
  arena().cars[1].place = {6.3, 5};
  arena().cars[2].place = {3.8, 5};
  arena().cars[2].velocity = {2, 0};
  Tick(0, "", 10);
  EXPECT_GT(arena().cars[1].velocity.x, 0.5);
  EXPECT_EQ(world_.outcome().state, State::kRunning);
}

TEST_F(BumperWorldTest, Day_PayRideLeave) {
  LoadTwo("strangers", {{"task", "day"}, {"ride_time", "5"}, {"spills", "1"}, {"thrills", "0"}});
  Tick(100, "", 10);
  EXPECT_NEAR(arena().cars[0].place.x, 5, 1e-9);  // not paid: the car does not move
  Tick(0, "pay", 20);
  EXPECT_THAT(Sensed(kScore), HasSubstr("paid"));
  Tick(100, "", 49);
  EXPECT_THAT(Sensed(kScore), Not(HasSubstr("ride_over")));
  Tick(0, "", 30);
  EXPECT_THAT(Sensed(kScore), HasSubstr("spill_count(1) thrill_count"));
  EXPECT_THAT(Sensed(kScore), HasSubstr("ride_over"));
  Tick(0, "leave", 30);
  EXPECT_EQ(world_.outcome().state, State::kRunning);  // not at the gate
  arena().cars[0].place = arena().gate;
  Tick(0, "leave", 20);
  EXPECT_EQ(world_.outcome().state, State::kReached);
}

TEST_F(BumperWorldTest, Day_LeftTooEarlyOrWithoutFun_Fails) {
  LoadTwo("strangers", {{"task", "day"}});
  Tick(0, "pay", 20);
  arena().cars[0].place = arena().gate;
  Tick(0, "leave", 20);
  EXPECT_EQ(world_.outcome().message, "left before the ride was over");
  LoadTwo("strangers", {{"task", "day"}, {"ride_time", "1"}});
  Tick(0, "pay", 40);
  arena().cars[0].place = arena().gate;
  Tick(0, "leave", 20);
  EXPECT_EQ(world_.outcome().message, "left after 0 of 3 spills and 0 of 5 thrills");
}

TEST_F(BumperWorldTest, FastDriving_CountsAsThrill) {
  LoadTwo("enemies", {{"width", "50"}});
  arena().cars[1].place = {5, 9};
  Tick(100, "", 60);
  EXPECT_THAT(Sensed(kScore), HasSubstr("thrill_count(5)"));
}

TEST_F(BumperWorldTest, EventsHappenOrSayWhyNot) {
  LoadTwo("enemies");
  EXPECT_THAT(Event("power_fails", "me"), IsEmpty());
  EXPECT_THAT(Sensed(kSelf), HasSubstr("power(off)"));
  EXPECT_THAT(Event("drives_on", "car1"), IsEmpty());
  EXPECT_FALSE(arena().cars[1].stalled);
  EXPECT_EQ(Event("stalls", "car9").at(0).message, "there is no car 'car9'");
  EXPECT_EQ(world_.HandleEvent(0, Fact(symbols_.Intern("bell"))).at(0).message, "nobody rides");
}

TEST_F(BumperWorldTest, MoreRamsThanEnemies_IsAnError) {
  const auto diagnostics = Load({{"enemies", "1"}, {"rams", "2"}});
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics[0].message, "more enemies are to be rammed than there are");
}

TEST_F(BumperWorldTest, SameSeed_SameRun) {
  std::vector<Vector> places;
  for (int run = 0; run < 2; ++run) {
    ASSERT_THAT(Load({}, 5), IsEmpty());
    Tick(60, "", 200);
    places.push_back(arena().cars[3].place);
  }
  EXPECT_EQ(places[0], places[1]);
  ASSERT_THAT(Load({}, 6), IsEmpty());
  Tick(60, "", 200);
  EXPECT_FALSE(arena().cars[3].place == places[0]);
}

TEST_F(BumperWorldTest, OtherCars_DriveAndRecharge) {
  ASSERT_THAT(Load({{"charge", "5"}}, 2), IsEmpty());
  int without = 0;
  std::vector<char> recharged(arena().cars.size(), 0);
  for (int i = 0; i < 1500; ++i) {
    Tick(0);
    for (std::size_t car = 1; car < arena().cars.size(); ++car) {
      if (!arena().cars[car].has_power()) ++without;
      if (arena().cars[car].charge == 5) recharged[car] = 1;
    }
  }
  EXPECT_GT(without, 0);
  EXPECT_THAT(std::vector<char>(recharged.begin() + 1, recharged.end()), testing::Each(1));
}

TEST_F(BumperWorldTest, DrawsAnAnimation) {
  const test::TemporaryFolder folder;
  LoadTwo("enemies");
  Tick(100, "", 40);
  EXPECT_THAT(world_.Draw(folder.path()), ElementsAre(folder.path() / "bumper_cars.svg"));
  EXPECT_GT(std::filesystem::file_size(folder.path() / "bumper_cars.svg"), 1000U);
  EXPECT_THAT(world_.Draw(folder.path() / "none"), IsEmpty());
}

}  // namespace
}  // namespace latchwork::bumper_cars
