// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/road.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace latchwork::traffic {
namespace {

class RoadTest : public ::testing::Test {
 protected:
  Road Make(double density, std::uint64_t seed) {
    return Road({.length = 1000, .density = density, .seed = seed}, symbols_);
  }
  logic::SymbolTable symbols_;
};

double MeanSpeed(const Road& road) {
  double sum = 0;
  for (const Car& car : road.cars()) sum += car.speed;
  return sum / static_cast<double>(road.cars().size());
}

TEST_F(RoadTest, CarsAlone_FlowChangeLanesAndNeverTouch) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Road road = Make(16, seed);
    std::size_t changes = 0;
    for (std::uint64_t tick = 0; tick < 1500; ++tick) {
      std::vector<int> aims;
      for (const Car& car : road.cars()) aims.push_back(car.aim);
      road.Step(tick, {});
      for (std::size_t i = 0; i < aims.size(); ++i) {
        if (road.cars()[i].aim != aims[i]) ++changes;
      }
      if (tick % 5 != 0) continue;
      ASSERT_EQ(road.TouchingOthers(), 0U) << "seed " << seed << " tick " << tick;
      ASSERT_FALSE(road.Touched());
    }
    EXPECT_GT(changes, 10U);
    EXPECT_GT(MeanSpeed(road), 15);
  }
}

TEST_F(RoadTest, DenserTraffic_IsSlower) {
  Road thin = Make(4, 1);
  Road dense = Make(30, 1);
  for (std::uint64_t tick = 0; tick < 600; ++tick) {
    thin.Step(tick, {});
    dense.Step(tick, {});
  }
  EXPECT_GT(MeanSpeed(thin), MeanSpeed(dense) + 2);
}

TEST_F(RoadTest, Ring_WaysAreCountedForward) {
  const Road road = Make(10, 1);
  EXPECT_DOUBLE_EQ(road.Forward(990, 10), 20);
  EXPECT_DOUBLE_EQ(road.Forward(10, 990), 980);
  EXPECT_DOUBLE_EQ(road.Forward(5, 5), 0);
}

TEST_F(RoadTest, Neighbours_SeeEachOtherWithTheSameGap) {
  Road road = Make(10, 2);
  for (std::uint64_t tick = 0; tick < 100; ++tick) road.Step(tick, {});
  for (std::size_t i = 0; i < road.cars().size(); ++i) {
    if (!road.cars()[i].settled()) continue;
    const auto ahead = road.Ahead(i, road.cars()[i].aim);
    ASSERT_TRUE(ahead);
    const auto back = road.Behind(ahead->car, road.cars()[i].aim);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->gap, ahead->gap, 1e-9);
  }
}

TEST_F(RoadTest, AgentStops_OthersBehindDoNotRunIntoIt) {
  Road road = Make(14, 3);
  for (std::uint64_t tick = 0; tick < 200; ++tick) road.Step(tick, {});
  for (std::uint64_t tick = 200; tick < 700; ++tick) {
    road.Step(tick, -4.0);
    ASSERT_FALSE(road.Touched()) << tick;
    ASSERT_EQ(road.TouchingOthers(), 0U) << tick;
  }
  EXPECT_EQ(road.cars()[Road::kAgent].speed, 0);
}

TEST_F(RoadTest, PlaceAgent_StandsFree) {
  Road road = Make(20, 4);
  for (std::uint64_t tick = 0; tick < 100; ++tick) road.Step(tick, {});
  road.PlaceAgent();
  EXPECT_FALSE(road.Touched());
  const Car& agent = road.cars()[Road::kAgent];
  EXPECT_TRUE(agent.settled());
  EXPECT_GT(road.Ahead(Road::kAgent, agent.aim)->gap, 10);
  EXPECT_GT(road.Behind(Road::kAgent, agent.aim)->gap, 10);
}

TEST_F(RoadTest, SameSeed_SameTraffic_AnotherSeed_Another) {
  const auto run = [&](std::uint64_t seed) {
    Road road = Make(12, seed);
    std::string text;
    for (std::uint64_t tick = 0; tick < 200; ++tick) road.Step(tick, {});
    for (const Car& car : road.cars()) text += std::to_string(car.s) + ' ';
    return text;
  };
  EXPECT_EQ(run(7), run(7));
  EXPECT_NE(run(7), run(8));
}

}  // namespace
}  // namespace latchwork::traffic
