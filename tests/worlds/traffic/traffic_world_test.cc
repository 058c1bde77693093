// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/traffic_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/temporary_folder.h"
#include "worlds/traffic/reward.h"
#include "worlds/traffic/traffic_contract.h"

namespace latchwork::traffic {
namespace {

using logic::Fact;
using logic::Term;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::Not;
using State = sdk::Outcome::State;

class TrafficWorldTest : public ::testing::Test {
 protected:
  void Load(const std::vector<std::pair<std::string, std::string>>& values,
            std::uint64_t seed = 1) {
    std::vector<sdk::Parameters::Given> given;
    for (const auto& [name, value] : values) given.push_back({name, value, {}});
    logic::Diagnostics diagnostics;
    const auto parameters =
        sdk::Parameters::Check(world_.parameters(), given, "traffic", {}, diagnostics);
    ASSERT_EQ(logic::Format(diagnostics), "");
    ASSERT_TRUE(world_.Load({seed, 0.1, {}, &symbols_}, parameters).empty());
    tick_ = 0;
  }

  void Tick(const std::vector<Fact>& drive) {
    world_.Observe(tick_, sensors_);
    const std::vector<sdk::Batch> effectors = {{true, drive}};
    world_.Apply(tick_, effectors);
    world_.Step(tick_++);
  }
  Fact Accelerate(double value) { return {symbols_.Intern("accelerate"), {Term::Real(value)}}; }
  Fact Aim(int lane) { return {symbols_.Intern("aim"), {Term::Integer(lane)}}; }
  Fact Event(const char* name, std::initializer_list<Term> terms) {
    return {symbols_.Intern(name), terms};
  }
  State RunWith(const std::vector<Fact>& drive, int ticks = 3000) {
    for (int i = 0; i < ticks && world_.outcome().state == State::kRunning; ++i) Tick(drive);
    return world_.outcome().state;
  }
  std::string Sensed(SensorPort port) const {
    std::string text;
    for (const Fact& fact : sensors_[port].facts) text += logic::ToString(fact) + ' ';
    return text;
  }
  double Measure(std::string_view name) const {
    for (const auto& [key, value] : world_.Measures()) {
      if (key == name) return value;
    }
    ADD_FAILURE() << name;
    return 0;
  }

  logic::SymbolTable symbols_;
  TrafficWorld world_;
  std::vector<sdk::Batch> sensors_ = std::vector<sdk::Batch>(kSensorPorts);
  std::uint64_t tick_ = 0;
};

TEST_F(TrafficWorldTest, Tick0_SaysRoadAndCarAndWhoIsInSight) {
  Load({});
  Tick({});
  EXPECT_EQ(Sensed(kRoad),
            "lane(0) lane(1) left_of(1, 0) lane(2) left_of(2, 1) speed_limit(30.0) ");
  EXPECT_THAT(Sensed(kSelf), HasSubstr("my_lane("));
  EXPECT_THAT(Sensed(kSelf), HasSubstr("exit_in(1500.0)"));
  EXPECT_THAT(Sensed(kCars), HasSubstr("ahead("));
  EXPECT_EQ(Sensed(kReward), "reward(0.0) ");
  Tick({});
  EXPECT_FALSE(sensors_[kRoad].updated);
}

TEST_F(TrafficWorldTest, EmptyRightLane_RollingToTheExit_Reached) {
  Load({{"lanes", "1"}, {"density", "0"}, {"brakings", "0"}});
  EXPECT_EQ(RunWith({Accelerate(0.1)}), State::kReached);
  EXPECT_EQ(Measure("trips_arrived"), 1);
  EXPECT_NEAR(Measure("distance_m"), 1500, 5);
}

TEST_F(TrafficWorldTest, BlindAcceleration_Collides) {
  Load({{"density", "20"}});
  EXPECT_EQ(RunWith({Accelerate(3)}), State::kFailed);
  EXPECT_THAT(world_.outcome().message, HasSubstr("collision with "));
  EXPECT_EQ(Measure("collisions"), 1);
  EXPECT_LT(Measure("reward"), 0);
}

TEST_F(TrafficWorldTest, SteeringPastTheEdge_LeavesTheRoad) {
  Load({{"lanes", "1"}, {"density", "0"}});
  EXPECT_EQ(RunWith({Accelerate(0), Aim(-1)}), State::kFailed);
  EXPECT_EQ(world_.outcome().message, "left the road");
}

TEST_F(TrafficWorldTest, WrongLaneAtTheExit_IsMissed) {
  Load({{"lanes", "2"}, {"density", "1"}, {"exit", "400"}});
  EXPECT_EQ(RunWith({Accelerate(0.0), Aim(1)}), State::kFailed);
  EXPECT_EQ(world_.outcome().message, "missed the exit, in lane 1");
}

TEST_F(TrafficWorldTest, Standing_TakesTooLong) {
  Load({{"lanes", "1"}, {"density", "0"}});
  EXPECT_EQ(RunWith({Accelerate(-3)}), State::kFailed);
  EXPECT_THAT(world_.outcome().message, HasSubstr("m from the exit after 70 s"));
  EXPECT_NEAR(Measure("time_s"), 70, 0.11);
}

TEST_F(TrafficWorldTest, SeveralTrips_GoOnAfterFailuresIfWanted) {
  Load({{"density", "20"}, {"trips", "4"}, {"end_at_failure", "false"}, {"exit", "600"}});
  EXPECT_EQ(RunWith({Accelerate(3)}, 5000), State::kFailed);
  EXPECT_THAT(world_.outcome().message, HasSubstr("of 4 trips failed"));
  EXPECT_EQ(Measure("trips_arrived") + Measure("trips_failed"), 4);
  EXPECT_EQ(Measure("others_touching"), 0);
}

TEST_F(TrafficWorldTest, Events_ChangeTheTrafficOrSayWhyNot) {
  Load({{"density", "15"}, {"speed_noise", "0"}, {"distance_noise", "0"}});
  Tick({Accelerate(0)});
  EXPECT_TRUE(world_.HandleEvent(1, Event("leader_brakes", {Term::Real(2)})).empty());
  const auto leader = world_.road().Ahead(Road::kAgent, world_.road().cars()[0].lane());
  const double before = world_.road().cars()[leader->car].speed;
  for (int i = 0; i < 10; ++i) Tick({Accelerate(-8)});
  EXPECT_LT(world_.road().cars()[leader->car].speed, before - 3);

  EXPECT_TRUE(world_.HandleEvent(1, Event("sight", {Term::Real(0)})).empty());
  Tick({Accelerate(0)});
  EXPECT_THAT(Sensed(kCars), Not(HasSubstr("ahead(")));

  EXPECT_EQ(world_.HandleEvent(1, Event("rain", {})).size(), 1U);
  EXPECT_EQ(world_.HandleEvent(1, Event("sight", {Term::Real(-1)})).size(), 1U);
  const Term nobody = Term::Constant(symbols_.Intern("nobody"));
  EXPECT_EQ(world_.HandleEvent(1, Event("brakes", {nobody, Term::Real(1)})).size(), 1U);
  const Car& other = world_.road().cars()[5];
  const double others_before = other.speed;
  const Term name = Term::Constant(other.name);
  EXPECT_TRUE(world_.HandleEvent(1, Event("brakes", {name, Term::Real(2)})).empty());
  for (int i = 0; i < 10; ++i) Tick({Accelerate(-8)});
  EXPECT_LT(other.speed, others_before - 3);
}

TEST_F(TrafficWorldTest, SameSeed_SameRun_AnotherSeed_Another) {
  const auto run = [&](std::uint64_t seed) {
    Load({}, seed);
    std::string text;
    for (int i = 0; i < 100; ++i) {
      Tick({Accelerate(-0.3)});
      text += Sensed(kSelf) + Sensed(kCars) + Sensed(kReward);
    }
    return text;
  };
  const std::string first = run(5);
  EXPECT_EQ(first, run(5));
  EXPECT_NE(first, run(6));
}

TEST_F(TrafficWorldTest, Draw_WritesThePicture) {
  Load({});
  RunWith({Accelerate(-0.2)}, 200);
  const TemporaryFolder folder;
  const auto files = world_.Draw(folder.path());
  ASSERT_EQ(files.size(), 1U);
  EXPECT_GT(std::filesystem::file_size(files[0]), 5000U);
  EXPECT_TRUE(world_.Draw("/nowhere/at/all").empty());
}

TEST(RewardTest, Progress_LessDiscomfort) {
  const Moment fine{.speed = 30, .headway = 1.5};
  EXPECT_DOUBLE_EQ(RewardRate(fine), 1);
  const auto worse = [&](auto change) {
    Moment moment = fine;
    change(moment);
    return RewardRate(moment) < RewardRate(fine) - 0.01;
  };
  EXPECT_TRUE(worse([](Moment& m) { m.speed = 20; }));
  EXPECT_TRUE(worse([](Moment& m) { m.speed = 35; }));
  EXPECT_TRUE(worse([](Moment& m) { m.acceleration = -3; }));
  EXPECT_TRUE(worse([](Moment& m) { m.side_speed = 1; }));
  EXPECT_TRUE(worse([](Moment& m) { m.headway = 0.3; }));
  EXPECT_TRUE(worse([](Moment& m) { m.follower_braking = 4; }));
}

}  // namespace
}  // namespace latchwork::traffic
