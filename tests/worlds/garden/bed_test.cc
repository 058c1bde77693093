// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/bed.h"

#include <gtest/gtest.h>

namespace latchwork::garden {
namespace {

constexpr Air kNoon{.temperature = 22, .light = 1, .rain = 0};
constexpr Air kNight{.temperature = 12, .light = 0, .rain = 0};

Bed Make(double small = 1, double large = 1) { return Bed({{.weight = small}, {.weight = large}}); }

TEST(BedTest, LightAndWarmth_MakeItGrowAndDry) {
  Bed bed = Make();
  const double moisture = bed.moisture();
  bed.Step(1, kNoon);
  EXPECT_GT(bed.weight(), 2);
  EXPECT_LT(bed.moisture(), moisture);
  EXPECT_LT(bed.food(), 30);
  Bed dark = Make();
  dark.Step(1, kNight);
  EXPECT_EQ(dark.weight(), 2);
}

TEST(BedTest, Rain_FillsTheSoilAndDrainsAway) {
  Bed bed = Make();
  for (int hour = 0; hour < 5; ++hour) bed.Step(1, {.temperature = 12, .light = 0, .rain = 8});
  EXPECT_GT(bed.moisture(), Bed::kDrainsAbove);
  EXPECT_LE(bed.moisture(), 1);
  const double food = bed.food();
  for (int hour = 0; hour < 48; ++hour) bed.Step(1, kNight);
  EXPECT_LE(bed.moisture(), Bed::kDrainsAbove + 0.01);
  EXPECT_LT(bed.food(), food) << "washed out";
}

TEST(BedTest, Soaked_Rots) {
  Bed bed = Make();
  for (int hour = 0; hour < 40; ++hour) {
    bed.AddWater(20);
    bed.Step(1, kNight);
  }
  EXPECT_LT(bed.pumpkins()[0].health, 0.75);
}

TEST(BedTest, Dry_WiltsAndTheSmallOneFirst) {
  Bed bed = Make(0.2, 20);
  bed.AddWater(-0.4 * Bed::kSoilHolds);
  for (int hour = 0; hour < 12; ++hour) bed.Step(1, kNight);
  EXPECT_LT(bed.pumpkins()[0].health, 1);
  EXPECT_LT(bed.pumpkins()[0].health, bed.pumpkins()[1].health);
}

TEST(BedTest, ScarceFood_GoesToTheLargePlant) {
  Bed scarce = Make(2, 12);
  scarce.AddFood(-27);
  Bed plenty = Make(2, 12);
  plenty.AddFood(20);
  for (int hour = 0; hour < 10; ++hour) {
    scarce.Step(1, kNoon);
    plenty.Step(1, kNoon);
  }
  const auto gained = [](const Bed& bed, std::size_t n, double from) {
    return bed.pumpkins()[n].weight - from;
  };
  const double small = gained(scarce, 0, 2) / gained(plenty, 0, 2);
  const double large = gained(scarce, 1, 12) / gained(plenty, 1, 12);
  EXPECT_LT(small, large);
  EXPECT_LT(large, 1);
}

TEST(BedTest, Frost_HarmsWhatLiesBare) {
  Bed bare = Make();
  Bed covered = Make();
  covered.SetCovered(true);
  for (int hour = 0; hour < 3; ++hour) {
    bare.Step(1, {.temperature = -2});
    covered.Step(1, {.temperature = -2});
  }
  EXPECT_NEAR(bare.pumpkins()[0].health, 0.4, 0.01);
  EXPECT_EQ(covered.pumpkins()[0].health, 1);
}

TEST(BedTest, Cover_KeepsLightAndRainAway) {
  Bed bare = Make();
  Bed covered = Make();
  covered.SetCovered(true);
  const double moisture = covered.moisture();
  bare.Step(1, {.temperature = 20, .light = 1, .rain = 10});
  covered.Step(1, {.temperature = 20, .light = 1, .rain = 10});
  EXPECT_GT(bare.moisture(), moisture);
  EXPECT_LT(covered.moisture(), moisture);
  EXPECT_LT(covered.weight(), bare.weight());
}

TEST(BedTest, TooMuchFood_Burns) {
  Bed bed = Make();
  bed.AddFood(70);
  bed.Step(10, kNight);
  EXPECT_LT(bed.pumpkins()[0].health, 1);
}

TEST(BedTest, DeadPlant_StaysDeadAndWeighsNothing) {
  Bed bed = Make();
  bed.Harm(1);
  for (int hour = 0; hour < 10; ++hour) bed.Step(1, kNoon);
  EXPECT_EQ(bed.pumpkins()[0].health, 0);
  EXPECT_EQ(bed.weight(), 0);
}

}  // namespace
}  // namespace latchwork::garden
