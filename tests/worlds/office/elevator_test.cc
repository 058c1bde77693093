// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/elevator.h"

#include <gtest/gtest.h>

#include <vector>

namespace latchwork::office {
namespace {

ElevatorOptions Quiet() {
  ElevatorOptions options;
  options.calls_per_hour = 0.0;
  return options;
}

/// Ticks until `done`, or 2000.
template <typename Done>
int TicksUntil(Elevator& elevator, Done done, bool curtain = false, bool occupied = false) {
  for (int tick = 0; tick < 2000; ++tick) {
    if (done()) return tick;
    elevator.Step(static_cast<std::uint64_t>(tick), curtain, occupied);
  }
  return 2000;
}

TEST(ElevatorTest, CalledFromAfar_TravelsThenOpens) {
  Elevator elevator(Quiet(), 3, 0.1, 1, "e1");
  elevator.Call(2);
  EXPECT_EQ(TicksUntil(elevator, [&] { return elevator.floor() == 2; }), 101);
  EXPECT_TRUE(elevator.is_shut());
  EXPECT_EQ(TicksUntil(elevator, [&] { return elevator.door() == Elevator::Door::kOpen; }), 20);
  EXPECT_FALSE(elevator.is_shut());
}

TEST(ElevatorTest, NobodyInTheDoor_ClosesAfterDwelling) {
  Elevator elevator(Quiet(), 3, 0.1, 1, "e1");
  elevator.Call(0);
  TicksUntil(elevator, [&] { return elevator.door() == Elevator::Door::kOpen; });
  const int closed = TicksUntil(elevator, [&] { return elevator.is_shut(); });
  EXPECT_GE(closed, 80);
  EXPECT_LE(closed, 82);
}

TEST(ElevatorTest, RobotInTheDoor_NeverCloses) {
  Elevator elevator(Quiet(), 3, 0.1, 1, "e1");
  elevator.Call(0);
  TicksUntil(elevator, [&] { return elevator.door() == Elevator::Door::kOpen; });
  TicksUntil(elevator, [&] { return elevator.door() == Elevator::Door::kClosing; });
  EXPECT_EQ(TicksUntil(
                elevator, [&] { return elevator.is_shut(); }, true),
            2000);
}

TEST(ElevatorTest, OutOfOrder_IgnoresCallsUntilInService) {
  Elevator elevator(Quiet(), 3, 0.1, 1, "e1");
  elevator.SetInService(false);
  elevator.Call(2);
  EXPECT_EQ(TicksUntil(elevator, [&] { return elevator.floor() == 2; }), 2000);
  elevator.SetInService(true);
  EXPECT_LT(TicksUntil(elevator, [&] { return elevator.floor() == 2; }), 200);
}

TEST(ElevatorTest, FailsWhileItCarries_OpensAtTheNextFloor) {
  Elevator elevator(Quiet(), 3, 0.1, 1, "e1");
  elevator.Call(2);
  for (std::uint64_t tick = 0; tick < 10; ++tick) elevator.Step(tick, false, true);
  elevator.SetInService(false);
  TicksUntil(
      elevator, [&] { return elevator.door() == Elevator::Door::kOpen; }, false, true);
  EXPECT_EQ(elevator.floor(), 1);
}

TEST(ElevatorTest, OtherPeople_CallBySeed) {
  ElevatorOptions busy;
  busy.calls_per_hour = 600.0;
  std::vector<int> floors[2];
  for (auto& seen : floors) {
    Elevator elevator(busy, 3, 0.1, 9, "e1");
    for (std::uint64_t tick = 0; tick < 3000; ++tick) {
      elevator.Step(tick, false, false);
      seen.push_back(elevator.floor());
    }
  }
  EXPECT_EQ(floors[0], floors[1]);
  EXPECT_NE(std::vector<int>(3000, 0), floors[0]);
}

}  // namespace
}  // namespace latchwork::office
