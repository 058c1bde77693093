// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/counted_allocations.h"
#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

constexpr int kSonars = 24;

void DescribeRobot(LayerMind& mind) {
  std::vector<std::string> facts = {"robot_radius(0.25)"};
  for (int sonar = 0; sonar < kSonars; ++sonar) {
    const double turn = 2 * std::numbers::pi;
    const double angle = 0.999 * std::remainder(turn * sonar / kSonars, turn);
    facts.push_back(fmt::format("sonar_direction({}, {:.6f})", sonar, angle));
  }
  mind.Latch("robot", facts);
  mind.Latch("objects",
             {"object(push_object)", "distance(push_object, 1.0)", "direction(push_object, 3.0)"});
}

/// No two cycles hear the same. Now and then a sonar hears nothing.
void Sense(LayerMind& mind, int cycle) {
  std::vector<std::string> facts;
  for (int sonar = 0; sonar < kSonars; ++sonar) {
    const double gap = 1.2 + 0.9 * std::cos(0.5 * sonar + 0.3 * cycle);
    facts.push_back((sonar + cycle) % 50 == 0
                        ? fmt::format("no_echo({})", sonar)
                        : fmt::format("sonar_reading({}, {:.6f})", sonar, gap));
  }
  mind.Latch("sonar", facts);
}

class AvoidAllocationTest : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Reasoners, AvoidAllocationTest,
                         ::testing::Values("pttp", "circumscription", "icarus"), ReasonerName);

TEST_P(AvoidAllocationTest, DecisionsAllocateNothingAfterWarmUp) {
  LayerMind mind("avoid", {}, GetParam());
  DescribeRobot(mind);
  for (int cycle = 0; cycle < 100; ++cycle) {
    Sense(mind, cycle);
    mind.Cycle();
  }
  for (int cycle = 100; cycle < 200; ++cycle) {
    Sense(mind, cycle);
    const std::size_t before = Allocations();
    mind.Cycle();
    EXPECT_EQ(Allocations(), before) << "cycle " << cycle;
    EXPECT_EQ(mind.decision().status, sdk::Status::kProved) << mind.decision().message;
  }
}

}  // namespace
}  // namespace latchwork::test
