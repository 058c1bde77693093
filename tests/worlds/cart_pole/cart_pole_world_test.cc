// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cart_pole/cart_pole_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/temporary_folder.h"
#include "worlds/cart_pole/cart_pole_contract.h"

namespace latchwork::cart_pole {
namespace {

using logic::Fact;
using logic::Term;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using State = sdk::Outcome::State;

class CartPoleWorldTest : public ::testing::Test {
 protected:
  using Values = std::vector<std::pair<std::string, std::string>>;

  void Load(const Values& values, std::uint64_t seed = 1, double tick = 0.02) {
    std::vector<sdk::Parameters::Given> given;
    for (const auto& [name, value] : values) given.push_back({name, value, {}});
    logic::Diagnostics diagnostics;
    const auto parameters =
        sdk::Parameters::Check(world_.parameters(), given, "cart_pole", {}, diagnostics);
    ASSERT_EQ(logic::Format(diagnostics), "");
    loaded_ = world_.Load({seed, tick, {}, &symbols_}, parameters);
    tick_ = 0;
  }
  void Tick(double force) {
    world_.Observe(tick_, sensors_);
    const std::vector<sdk::Batch> effectors = {
        {true, {Fact(symbols_.Intern("force"), {Term::Real(force)})}}};
    world_.Apply(tick_, effectors);
    world_.Step(tick_++);
  }
  /// Linear feedback from the true state.
  double Balance() const {
    const Motion& motion = world_.motion();
    return 45 * (motion.angle + 0.28 * motion.rate + 0.06 * motion.place + 0.09 * motion.speed);
  }
  double Read(std::size_t fact) const { return sensors_[kMotion].facts[fact].argument(0).number(); }
  double Measure(std::string_view name) const {
    for (const auto& [key, value] : world_.Measures()) {
      if (key == name) return value;
    }
    ADD_FAILURE() << name;
    return 0;
  }
  Fact Event(const char* name, double value) {
    return {symbols_.Intern(name), {Term::Real(value)}};
  }

  const Values calm_{{"start_angle", "0"}, {"start_rate", "0"},  {"start_place", "0"},
                     {"start_speed", "0"}, {"pushes", "0"},      {"angle_noise", "0"},
                     {"rate_noise", "0"},  {"place_noise", "0"}, {"speed_noise", "0"}};
  logic::SymbolTable symbols_;
  CartPoleWorld world_;
  logic::Diagnostics loaded_;
  std::vector<sdk::Batch> sensors_ = std::vector<sdk::Batch>(kSensorPorts);
  std::uint64_t tick_ = 0;
};

TEST_F(CartPoleWorldTest, Sensors_SayStateAndTrack) {
  Load(calm_);
  Tick(0);
  ASSERT_EQ(sensors_[kMotion].facts.size(), 4U);
  EXPECT_EQ(logic::ToString(sensors_[kMotion].facts[0]), "pole_angle(0.0)");
  EXPECT_EQ(logic::ToString(sensors_[kTrack].facts[0]), "track_end(2.4)");
  EXPECT_EQ(logic::ToString(sensors_[kTrack].facts[1]), "force_limit(10.0)");
  Tick(0);
  EXPECT_FALSE(sensors_[kTrack].updated);
}

TEST_F(CartPoleWorldTest, Nobody_LetsThePoleFall) {
  Load({});
  while (world_.outcome().state == State::kRunning) Tick(0);
  EXPECT_EQ(world_.outcome().state, State::kFailed);
  EXPECT_THAT(world_.outcome().message, HasSubstr("the pole fell to the "));
  EXPECT_LT(Measure("time_s"), 5);
}

TEST_F(CartPoleWorldTest, Feedback_KeepsItUprightForAMinute) {
  Load({}, 3);
  while (world_.outcome().state == State::kRunning) Tick(Balance());
  EXPECT_EQ(world_.outcome().state, State::kReached) << world_.outcome().message;
  EXPECT_EQ(world_.outcome().message, "upright for 60 s");
  EXPECT_NEAR(Measure("time_s"), 60, 1e-9);
  EXPECT_GT(Measure("pushes"), 0);
}

TEST_F(CartPoleWorldTest, EndOfTheTrack_IsAFailure) {
  Values values = calm_;
  values.emplace_back("fallen", "1.5");
  values.emplace_back("track_end", "0.2");
  Load(values);
  while (world_.outcome().state == State::kRunning) Tick(5);
  EXPECT_THAT(world_.outcome().message, HasSubstr("ran into the right end"));
}

TEST_F(CartPoleWorldTest, Force_IsLimitedByTheMotor) {
  Load(calm_);
  Tick(1e9);
  const double limited = world_.motion().speed;
  Load(calm_);
  Tick(10);
  EXPECT_EQ(world_.motion().speed, limited);
  Tick(std::nan(""));
  EXPECT_TRUE(std::isfinite(world_.motion().speed));
}

TEST_F(CartPoleWorldTest, Pushes_AreEventsToo) {
  Load(calm_);
  EXPECT_TRUE(world_.HandleEvent(0, Event("push_pole", 0.02)).empty());
  EXPECT_GT(world_.motion().rate, 0.3);
  EXPECT_TRUE(world_.HandleEvent(0, Event("push_cart", -0.5)).empty());
  EXPECT_LT(world_.motion().speed, -0.3);
  EXPECT_EQ(Measure("pushes"), 2);
  EXPECT_EQ(world_.HandleEvent(0, Event("push_pole", 1e9)).size(), 1U);
  EXPECT_EQ(world_.HandleEvent(0, Event("rain", 1)).size(), 1U);
}

TEST_F(CartPoleWorldTest, Noise_HasTheStatedWidth) {
  Values values = calm_;
  values[5].second = "0.1";
  Load(values);
  double sum = 0;
  constexpr int kDraws = 4000;
  for (int i = 0; i < kDraws; ++i) {
    world_.Observe(static_cast<std::uint64_t>(i), sensors_);
    sum += Read(0) * Read(0);
    EXPECT_EQ(Read(1), 0);
  }
  EXPECT_NEAR(std::sqrt(sum / kDraws), 0.1, 0.005);
}

TEST_F(CartPoleWorldTest, Seeds_GiveStartsWithinTheRange) {
  double least = 1;
  double most = -1;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Load({}, seed);
    const Motion& motion = world_.motion();
    EXPECT_LE(std::abs(motion.angle), 0.15);
    EXPECT_LE(std::abs(motion.place), 1.0);
    least = std::min(least, motion.angle);
    most = std::max(most, motion.angle);
  }
  EXPECT_LT(least, -0.1);
  EXPECT_GT(most, 0.1);
}

TEST_F(CartPoleWorldTest, SameSeed_SameRun) {
  const auto run = [&](std::uint64_t seed) {
    Load({}, seed);
    for (int i = 0; i < 500; ++i) Tick(Balance());
    return std::pair(world_.motion().angle, world_.motion().place);
  };
  EXPECT_EQ(run(4), run(4));
  EXPECT_NE(run(4), run(5));
}

TEST_F(CartPoleWorldTest, TickTooLong_IsRefused) {
  Load({}, 1, 0.2);
  EXPECT_THAT(logic::Format(loaded_), HasSubstr("at most 100ms"));
}

TEST_F(CartPoleWorldTest, Draw_WritesThePicture) {
  Load({});
  for (int i = 0; i < 100; ++i) Tick(Balance());
  const TemporaryFolder folder;
  const auto files = world_.Draw(folder.path());
  ASSERT_EQ(files.size(), 1U);
  EXPECT_GT(std::filesystem::file_size(files[0]), 3000U);
  EXPECT_TRUE(world_.Draw("/nowhere/at/all").empty());
}

}  // namespace
}  // namespace latchwork::cart_pole
