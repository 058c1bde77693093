// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class PoleBalancerTest : public ::testing::Test {
 protected:
  /// The force on the cart, as text.
  std::vector<std::string> Decide(const std::string& angle, const std::string& rate,
                                  const std::string& place, const std::string& speed) {
    mind_.Latch("motion", {"pole_angle(" + angle + ")", "pole_rate(" + rate + ")",
                           "cart_place(" + place + ")", "cart_speed(" + speed + ")"});
    return mind_.Decide();
  }
  LayerMind mind_{"pole_balancer",
                  {{"safe_lean", "0.125", {}},
                   {"middle", "0.25", {}},
                   {"greatest_lean", "0.0625", {}},
                   {"stiffness", "40", {}}},
                  kIcarusMind};
};

TEST_F(PoleBalancerTest, UprightInTheMiddle_LetsItRoll) {
  EXPECT_THAT(Decide("0.05", "0.0", "0.2", "0.0"), IsEmpty());
}

TEST_F(PoleBalancerTest, FallingPole_IsCaughtWhereverTheCartIs) {
  EXPECT_THAT(Decide("0.25", "0.0", "2.0", "0.0"), ElementsAre("force(10.0)"));
  EXPECT_THAT(Decide("-0.25", "0.0", "2.0", "0.0"), ElementsAre("force(-10.0)"));
  EXPECT_THAT(Decide("0.0", "1.0", "0.0", "0.0"), ElementsAre(StartsWith("force(11.2")));
}

TEST_F(PoleBalancerTest, CartAside_IsDrivenOutwardsSoThatThePoleLeansBack) {
  EXPECT_THAT(Decide("0.0", "0.0", "2.0", "0.0"), ElementsAre("force(2.5)"));
  EXPECT_THAT(Decide("0.0", "0.0", "-2.0", "0.0"), ElementsAre("force(-2.5)"));
}

TEST_F(PoleBalancerTest, PoleLeansBackEnough_NeedsNoForce) {
  EXPECT_THAT(Decide("-0.0625", "0.0", "2.0", "0.0"), ElementsAre("force(0.0)"));
}

TEST_F(PoleBalancerTest, CartOnItsWayOut_IsSeenBeforeItIsThere) {
  EXPECT_THAT(Decide("0.0", "0.0", "0.0", "2.0"), ElementsAre("force(2.5)"));
}

}  // namespace
}  // namespace latchwork::test
