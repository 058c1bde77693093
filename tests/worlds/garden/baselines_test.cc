// SPDX-License-Identifier: BSD-3-Clause
//
// What a season comes to without a gardener that thinks: the measure of the world lies well above.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "latchwork/sdk/parameters.h"
#include "tests/worlds/garden/fixed_round.h"
#include "worlds/garden/garden_contract.h"

namespace latchwork::garden {
namespace {

constexpr int kDays = 70;
constexpr int kBeds = 6;

double GoalWeight() { return sdk::Parameters::Defaults(GardenParameters()).Real("goal_weight"); }

GardenState Season(std::uint64_t seed) { return {seed, kDays, kBeds, 3, GardenerOptions{}, 50}; }

/// The mean harvest of 20 seasons; none of them reaches the goal.
double MeanHarvest(const FixedRound::Plan& plan) {
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    GardenState state = Season(seed);
    const Harvest harvest = RunSeason(state, kDays, FixedRound(plan, kBeds));
    EXPECT_FALSE(harvest.alive == harvest.plants && harvest.weight >= GoalWeight())
        << "seed " << seed << ": " << harvest.weight << " kg";
    sum += harvest.weight / 20;
  }
  return sum;
}

TEST(BaselinesTest, NothingDone_AllIsDead) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    GardenState state = Season(seed);
    const auto rest = [](const GardenState&) { return std::optional<Task>(); };
    EXPECT_EQ(RunSeason(state, kDays, rest).alive, 0) << "seed " << seed;
  }
}

TEST(BaselinesTest, FixedRoundWithLittleWater_MostIsDead) {
  EXPECT_LT(MeanHarvest({.litres = 20}), 0.3 * GoalWeight());
}

TEST(BaselinesTest, FixedRoundWithMuchWater_GrowsTooLittle) {
  const double mean = MeanHarvest({.litres = 40});
  EXPECT_GT(mean, 0.4 * GoalWeight()) << "a fair baseline";
  EXPECT_LT(mean, 0.7 * GoalWeight());
}

TEST(BaselinesTest, FixedRoundThatNeverCovers_FreezesOrDrowns) {
  EXPECT_LT(MeanHarvest({.litres = 40, .covers = false}), 0.95 * GoalWeight());
}

}  // namespace
}  // namespace latchwork::garden
