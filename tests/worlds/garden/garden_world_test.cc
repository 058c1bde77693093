// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/garden_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/temporary_folder.h"
#include "worlds/garden/garden_contract.h"

namespace latchwork::garden {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using State = sdk::Outcome::State;

class GardenWorldTest : public ::testing::Test {
 protected:
  void Load(const std::vector<std::pair<std::string, std::string>>& values = {},
            std::uint64_t seed = 1) {
    std::vector<sdk::Parameters::Given> given;
    for (const auto& [name, value] : values) given.push_back({name, value, {}});
    logic::Diagnostics diagnostics;
    const auto parameters =
        sdk::Parameters::Check(world_.parameters(), given, "garden", {}, diagnostics);
    ASSERT_EQ(logic::Format(diagnostics), "");
    ASSERT_TRUE(world_.Load({seed, 300, {}, &symbols_}, parameters).empty());
  }

  void Ticks(int count, std::vector<logic::Fact> work) {
    std::vector<sdk::Batch> effectors(kEffectorPorts);
    effectors[kWork] = {true, std::move(work)};
    for (int i = 0; i < count; ++i) {
      world_.Observe(tick_, sensors_);
      world_.Apply(tick_, effectors);
      world_.Step(tick_++);
    }
  }

  std::string Sensed(SensorPort port) {
    world_.Observe(tick_, sensors_);
    std::string text;
    for (const auto& fact : sensors_[port].facts) text += logic::ToString(fact) + " ";
    return text;
  }
  logic::Fact Make(const char* name, std::initializer_list<logic::Term> terms = {}) {
    return terms.size() == 0 ? logic::Fact(symbols_.Intern(name))
                             : logic::Fact(symbols_.Intern(name), terms);
  }
  logic::Term Word(const char* name) { return logic::Term::Constant(symbols_.Intern(name)); }

  logic::SymbolTable symbols_;
  GardenWorld world_;
  std::vector<sdk::Batch> sensors_ = std::vector<sdk::Batch>(kSensorPorts);
  std::uint64_t tick_ = 0;
};

TEST_F(GardenWorldTest, FirstTick_TellsOfTheBeds) {
  Load();
  EXPECT_THAT(Sensed(kMap), HasSubstr("bed(b1, 40.0) bed(b2, 80.0)"));
  EXPECT_THAT(Sensed(kClock), HasSubstr("day(0) hour(0.0)"));
  EXPECT_THAT(Sensed(kClock), Not(HasSubstr("working")));
  EXPECT_THAT(Sensed(kForecast), HasSubstr("low_expected("));
  EXPECT_THAT(Sensed(kInspection), HasSubstr("at(well)"));
  EXPECT_EQ(Sensed(kStock), "tank(0.0) barrel(400.0) portions(50) ");
}

TEST_F(GardenWorldTest, Night_NothingIsDone) {
  Load();
  Ticks(12, {Make("fill")});
  EXPECT_THAT(Sensed(kStock), HasSubstr("tank(0.0)"));
  Ticks(5 * 12 + 1, {Make("fill")});
  EXPECT_THAT(Sensed(kClock), HasSubstr("working"));
  EXPECT_THAT(Sensed(kStock), HasSubstr("tank(40.0)"));
}

TEST_F(GardenWorldTest, Walk_LeadsToTheBedAndWhatGrowsThere) {
  Load();
  Ticks(6 * 12, {});
  Ticks(1, {Make("walk", {Word("b3")})});
  EXPECT_EQ(Sensed(kInspection), "") << "on its way";
  Ticks(2, {Make("walk", {Word("b3")})});
  EXPECT_THAT(Sensed(kInspection), HasSubstr("at(b3) food(b3, "));
  EXPECT_THAT(Sensed(kInspection), HasSubstr("pumpkin(b3, 3, "));
  Ticks(2, {Make("walk", {Word("moon")})});
  EXPECT_THAT(Sensed(kInspection), HasSubstr("at(b3)")) << "there is no such place";
}

TEST_F(GardenWorldTest, Probes_AreNoisyButTrue) {
  Load();
  double sum = 0;
  for (int i = 0; i < 200; ++i) {
    Sensed(kBeds);
    const double moisture = sensors_[kBeds].facts[0].argument(1).number();
    EXPECT_NEAR(moisture, 0.55, 0.1);
    sum += moisture;
    ++tick_;
  }
  EXPECT_NEAR(sum / 200, 0.55, 0.01);
}

TEST_F(GardenWorldTest, EndOfSeason_IsJudged) {
  Load({{"days", "2"}, {"goal_weight", "1"}});
  Ticks(2 * 288 - 1, {});
  EXPECT_EQ(world_.outcome().state, State::kRunning);
  Ticks(1, {});
  EXPECT_EQ(world_.outcome().state, State::kReached) << world_.outcome().message;
  Load({{"days", "2"}, {"goal_weight", "1000"}});
  Ticks(2 * 288, {});
  EXPECT_EQ(world_.outcome().state, State::kFailed);
}

TEST_F(GardenWorldTest, AllDead_RunIsOver) {
  Load({{"beds", "1"}});
  Ticks(10, {});
  EXPECT_TRUE(world_.HandleEvent(0, Make("slugs", {Word("b1"), logic::Term::Real(1)})).empty());
  Ticks(1, {});
  EXPECT_EQ(world_.outcome().state, State::kFailed);
  EXPECT_EQ(world_.outcome().message, "all pumpkins are dead on day 1 of 70");
}

TEST_F(GardenWorldTest, Events_ChangeTheGarden) {
  Load();
  EXPECT_TRUE(world_.HandleEvent(0, Make("spring_gives", {logic::Term::Real(2)})).empty());
  EXPECT_EQ(world_.state().barrel.spring, 2);
  EXPECT_TRUE(world_.HandleEvent(0, Make("food_delivered", {logic::Term::Integer(5)})).empty());
  EXPECT_EQ(world_.state().gardener.portions(), 55);
  EXPECT_TRUE(world_.HandleEvent(0, Make("slugs", {Word("b2"), logic::Term::Real(0.25)})).empty());
  EXPECT_EQ(world_.state().beds[1].pumpkins()[0].health, 0.75);
  EXPECT_FALSE(world_.HandleEvent(0, Make("slugs", {Word("b9"), logic::Term::Real(0.2)})).empty());
  EXPECT_FALSE(world_.HandleEvent(0, Make("spring_gives", {logic::Term::Real(-2)})).empty());
}

TEST_F(GardenWorldTest, Draw_WritesTwoPictures) {
  Load();
  Ticks(300, {});
  const test::TemporaryFolder folder;
  const auto files = world_.Draw(folder.path());
  ASSERT_EQ(files.size(), 2U);
  for (const auto& file : files) EXPECT_GT(std::filesystem::file_size(file), 1000U);
}

}  // namespace
}  // namespace latchwork::garden
