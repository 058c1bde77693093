// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/gardener.h"

#include <gtest/gtest.h>

namespace latchwork::garden {
namespace {

class GardenerTest : public ::testing::Test {
 protected:
  void Work(Task::Kind kind, int steps = 1, std::size_t place = kWell) {
    for (int i = 0; i < steps; ++i) gardener_.Work(Task{kind, place}, 300, beds_, barrel_);
  }
  void WalkTo(std::size_t place) { Work(Task::Kind::kWalk, 10, place); }

  std::vector<Bed> beds_ = std::vector<Bed>(3, Bed({Pumpkin{}}));
  Barrel barrel_;
  Gardener gardener_{GardenerOptions{}, 2};
};

TEST_F(GardenerTest, Walk_TakesItsTime) {
  EXPECT_EQ(gardener_.place(3), kWell);
  Work(Task::Kind::kWalk, 1, 2);
  EXPECT_EQ(gardener_.way(), 75);
  EXPECT_EQ(gardener_.place(3), std::nullopt) << "between two beds";
  Work(Task::Kind::kWalk, 1, 2);
  EXPECT_EQ(gardener_.place(3), 2U);
  EXPECT_EQ(gardener_.walked(), 120);
}

TEST_F(GardenerTest, Water_GoesFromBarrelToBed) {
  Work(Task::Kind::kFill, 2);
  EXPECT_EQ(gardener_.water(), 40);
  EXPECT_EQ(barrel_.water, 360);
  WalkTo(1);
  const double before = beds_[1].moisture();
  Work(Task::Kind::kPour, 3);
  EXPECT_NEAR(beds_[1].moisture() - before, 40 / Bed::kSoilHolds, 1e-12);
  EXPECT_EQ(gardener_.water(), 0);
  EXPECT_EQ(gardener_.poured(), 40);
}

TEST_F(GardenerTest, EmptyBarrel_GivesWhatItHas) {
  barrel_.water = 5;
  Work(Task::Kind::kFill, 3);
  EXPECT_EQ(gardener_.water(), 5);
  EXPECT_EQ(barrel_.water, 0);
}

TEST_F(GardenerTest, Food_ComesInPortions) {
  WalkTo(0);
  Work(Task::Kind::kFeed, 3);
  EXPECT_EQ(beds_[0].food(), 50) << "two portions of 10 g, no more are left";
  EXPECT_EQ(gardener_.portions(), 0);
}

TEST_F(GardenerTest, Cover_TakesTwoStepsWithoutABreak) {
  WalkTo(0);
  Work(Task::Kind::kCover);
  Work(Task::Kind::kPour);
  Work(Task::Kind::kCover);
  EXPECT_FALSE(beds_[0].covered()) << "begun anew";
  Work(Task::Kind::kCover);
  EXPECT_TRUE(beds_[0].covered());
  Work(Task::Kind::kUncover, 2);
  EXPECT_FALSE(beds_[0].covered());
}

TEST_F(GardenerTest, WrongPlace_DoesNothing) {
  Work(Task::Kind::kFeed, 2);
  Work(Task::Kind::kCover, 4);
  EXPECT_EQ(gardener_.portions(), 2);
  WalkTo(1);
  Work(Task::Kind::kFill, 2);
  EXPECT_EQ(gardener_.water(), 0);
}

}  // namespace
}  // namespace latchwork::garden
