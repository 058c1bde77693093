// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/worlds/office/test_map.h"
#include "worlds/office/collision.h"

namespace latchwork::office {
namespace {

TEST(CollisionTest, DiscAgainstCellSquare_IsExact) {
  const FloorMap map{Hall()};
  EXPECT_FALSE(FindContact(map, {0.3501, 3.0}, 0.25));
  EXPECT_TRUE(FindContact(map, {0.3499, 3.0}, 0.25));
  // The corner of the post at 6.9, 3.9.
  EXPECT_FALSE(FindContact(map, {6.9 - 0.1769, 3.9 - 0.1769}, 0.25));
  EXPECT_TRUE(FindContact(map, {6.9 - 0.1766, 3.9 - 0.1766}, 0.25));
}

TEST(VehicleTest, DrivesIntoWall_StopsAtContact) {
  const FloorMap map{Hall()};
  Vehicle vehicle({}, 0.1);
  vehicle.Place({1.0, 3.0, std::numbers::pi});
  vehicle.Forward(0.6);
  int contacts = 0;
  for (int i = 0; i < 40; ++i) contacts += vehicle.Step(map, {}) ? 1 : 0;
  EXPECT_GT(contacts, 0);
  EXPECT_GE(vehicle.pose().x, 0.35);
  EXPECT_LT(vehicle.pose().x, 0.36);
}

TEST(VehicleTest, Speed_KeepsWithinItsAcceleration) {
  const FloorMap map{Hall()};
  Vehicle vehicle({}, 0.1);
  vehicle.Place({1.0, 2.0, 0.0});
  vehicle.Forward(5.0);
  EXPECT_FALSE(vehicle.Step(map, {}));
  EXPECT_NEAR(vehicle.speed(), 0.1, 1e-12);
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(vehicle.Step(map, {}));
  EXPECT_NEAR(vehicle.speed(), 0.6, 1e-12);
  vehicle.Forward(std::nullopt);
  EXPECT_FALSE(vehicle.Step(map, {}));
  EXPECT_NEAR(vehicle.speed(), 0.45, 1e-12);
}

TEST(VehicleTest, Turn_ReachesTheAngleWithoutOvershoot) {
  const FloorMap map{Hall()};
  for (const double angle : {0.05, 0.7, -2.0, 3.1}) {
    Vehicle vehicle({}, 0.1);
    vehicle.Place({3.0, 3.0, 0.4});
    vehicle.Turn(angle);
    double farthest = 0.0;
    for (int i = 0; i < 60; ++i) {
      EXPECT_FALSE(vehicle.Step(map, {}));
      farthest = std::max(farthest, std::abs(WrapAngle(vehicle.pose().heading - 0.4)));
    }
    EXPECT_NEAR(WrapAngle(vehicle.pose().heading - 0.4), angle, 0.01);
    EXPECT_LT(farthest, std::abs(angle) + 0.02);
  }
}

TEST(VehicleTest, StandingTouchedByPerson_MayDriveAway) {
  const FloorMap map{Hall()};
  Vehicle vehicle({}, 0.1);
  vehicle.Place({3.0, 3.0, 0.0});
  const std::array<Disc, 1> behind{Disc{{2.56, 3.0}, 0.2}};
  const std::array<Disc, 1> ahead{Disc{{3.44, 3.0}, 0.2}};
  vehicle.Forward(0.5);
  EXPECT_FALSE(vehicle.Step(map, behind));
  vehicle.Place({3.0, 3.0, 0.0});
  vehicle.Forward(0.5);
  EXPECT_TRUE(vehicle.Step(map, ahead));
}

}  // namespace
}  // namespace latchwork::office
