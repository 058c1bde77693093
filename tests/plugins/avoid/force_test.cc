// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/avoid/force.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace latchwork::avoid {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr RelativeObject kPushAhead{1.0, kPi, true};

std::vector<RelativeObject> Mirrored(std::vector<RelativeObject> objects) {
  for (RelativeObject& object : objects) object.direction = -object.direction;
  return objects;
}

TEST(ForceTest, NothingAround_NoForce) {
  const Force force = SumForces({}, {});
  EXPECT_EQ(force.strength, 0.0);
  EXPECT_EQ(force.direction, 0.0);
}

TEST(ForceTest, FarObject_NoForce) {
  const ForceLaw law;
  const std::array objects{RelativeObject{law.robot_radius + law.influence, 1.0, false}};
  EXPECT_EQ(SumForces(law, objects).strength, 0.0);
}

TEST(ForceTest, SensedObject_RepelsStraightAwayWithoutPush) {
  const std::array objects{RelativeObject{0.6, 0.5, false}};
  const Force force = SumForces({}, objects);
  EXPECT_GT(force.strength, 0.0);
  EXPECT_NEAR(force.direction, 0.5 - kPi, 1e-12);
}

TEST(ForceTest, NearerObject_RepelsMore) {
  double last = 0.0;
  for (double distance = 1.0; distance > 0.3; distance -= 0.05) {
    const std::array objects{RelativeObject{distance, 0.0, false}};
    const double strength = SumForces({}, objects).strength;
    EXPECT_GT(strength, last) << distance;
    last = strength;
  }
}

TEST(ForceTest, ReadingOfNought_StaysFinite) {
  const std::array objects{RelativeObject{0.0, 0.0, false}, RelativeObject{0.0, 1.0, true}};
  EXPECT_TRUE(std::isfinite(SumForces({}, objects).strength));
}

TEST(ForceTest, VirtualObject_PushesAwayFromItAndWeakerFromAfar) {
  const std::array near{RelativeObject{1.0, kPi, true}};
  const std::array far{RelativeObject{2.0, kPi, true}};
  EXPECT_NEAR(SumForces({}, near).direction, 0.0, 1e-12);
  EXPECT_NEAR(SumForces({}, near).strength, 2.0 * SumForces({}, far).strength, 1e-12);
}

TEST(ForceTest, MirroredWorld_MirroredForce) {
  const std::vector<RelativeObject> objects{
      {0.5, 0.3, false}, {0.7, 1.2, false}, {0.45, -2.0, false}, {1.0, 2.8, true}};
  const Force force = SumForces({}, objects);
  const Force mirrored = SumForces({}, Mirrored(objects));
  EXPECT_NEAR(force.strength, mirrored.strength, 1e-12);
  EXPECT_NEAR(force.direction, -mirrored.direction, 1e-12);
}

TEST(ForceTest, DoorPosts_PullThrough) {
  const std::array objects{RelativeObject{0.7, 0.7, false}, RelativeObject{0.7, -0.7, false},
                           kPushAhead};
  const Force force = SumForces({}, objects);
  EXPECT_NEAR(force.direction, 0.0, 1e-9);
  EXPECT_GT(force.strength, 0.9);
}

TEST(ForceTest, ObstacleAheadToTheLeft_PassedOnTheRight) {
  const std::array objects{RelativeObject{0.5, 0.2, false}, kPushAhead};
  EXPECT_LT(SumForces({}, objects).direction, 0.0);
}

TEST(ForceTest, ObstacleDeadAhead_PassedOnTheRight) {
  const std::array objects{RelativeObject{0.5, 0.0, false}, kPushAhead};
  EXPECT_LT(SumForces({}, objects).direction, 0.0);
}

TEST(FreeAheadTest, NothingAround_Horizon) { EXPECT_EQ(FreeAhead(0.25, 0.1, 0.2, 3.0, {}), 3.0); }

TEST(FreeAheadTest, ObjectAhead_GapLessMargin) {
  const std::array objects{RelativeObject{1.25, 0.0, false}};
  EXPECT_NEAR(FreeAhead(0.25, 0.1, 0.2, 3.0, objects), 0.9, 1e-12);
}

TEST(FreeAheadTest, ObjectBesideOrBehind_Horizon) {
  const std::array objects{RelativeObject{0.5, kPi / 2, false}, RelativeObject{0.4, kPi, false}};
  EXPECT_EQ(FreeAhead(0.25, 0.1, 0.2, 3.0, objects), 3.0);
}

TEST(FreeAheadTest, ObjectAtTheEdgeOfACone_TakenAtItsWorstPlace) {
  const std::array objects{RelativeObject{1.0, 0.39, false}};
  EXPECT_EQ(FreeAhead(0.25, 0.1, 0.0, 3.0, objects), 3.0);
  EXPECT_LT(FreeAhead(0.25, 0.1, 0.22, 3.0, objects), 1.0);
}

TEST(FreeAheadTest, VirtualObject_IsNotInTheWay) {
  const std::array objects{RelativeObject{0.5, 0.0, true}};
  EXPECT_EQ(FreeAhead(0.25, 0.1, 0.2, 3.0, objects), 3.0);
}

TEST(FreeAheadTest, Touching_Nought) {
  const std::array objects{RelativeObject{0.25, 0.0, false}};
  EXPECT_EQ(FreeAhead(0.25, 0.1, 0.2, 3.0, objects), 0.0);
}

}  // namespace
}  // namespace latchwork::avoid
