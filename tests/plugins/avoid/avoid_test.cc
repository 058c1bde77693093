// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const std::vector<std::string> kRobot{"sonar_direction(0, 0.0)", "sonar_direction(1, 1.5)",
                                      "sonar_direction(2, -0.4)", "robot_radius(0.25)"};
const std::vector<std::string> kPushAhead{"object(push)", "distance(push, 1.0)",
                                          "direction(push, 3.14159)"};

class AvoidTest : public ::testing::TestWithParam<const char*> {
 protected:
  AvoidTest() {
    mind_.Latch("robot", kRobot);
    mind_.Latch("sonar", {"no_echo(0)", "no_echo(1)", "no_echo(2)"});
  }
  LayerMind mind_{"avoid", {}, GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Reasoners, AvoidTest,
                         ::testing::Values("pttp", "circumscription", "icarus"), ReasonerName);

TEST_P(AvoidTest, NothingAround_NothingToDo) { EXPECT_THAT(mind_.Decide(), IsEmpty()); }

TEST_P(AvoidTest, PushFromBehind_GoesForward) {
  mind_.Latch("objects", kPushAhead);
  EXPECT_THAT(mind_.Decide(), ElementsAre(StartsWith("fwd(0.59")));
}

TEST_P(AvoidTest, PushFromTheLeft_TurnsRight) {
  mind_.Latch("objects", {"object(push)", "distance(push, 1.0)", "direction(push, 1.5)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre(StartsWith("turn(-1.64")));
}

TEST_P(AvoidTest, ObjectAhead_HaltsWhateverPushes) {
  mind_.Latch("objects", kPushAhead);
  mind_.Latch("sonar", {"sonar_reading(0, 0.1)", "no_echo(1)", "no_echo(2)"});
  EXPECT_THAT(mind_.Decide(), Contains("halt"));
  EXPECT_THAT(mind_.Decide(), Not(Contains(StartsWith("fwd"))));
}

TEST_P(AvoidTest, ObjectAheadGone_DefaultRestored) {
  mind_.Latch("objects", kPushAhead);
  mind_.Latch("sonar", {"sonar_reading(0, 0.1)"});
  EXPECT_THAT(mind_.Decide(), Contains("halt"));
  mind_.Latch("sonar", {"no_echo(0)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre(StartsWith("fwd")));
}

TEST_P(AvoidTest, ObjectBeside_DoesNotHalt) {
  mind_.Latch("objects", kPushAhead);
  mind_.Latch("sonar", {"sonar_reading(1, 0.1)"});
  EXPECT_THAT(mind_.Decide(), Not(Contains("halt")));
}

TEST_P(AvoidTest, VirtualObjectAheadAndNear_Halts) {
  mind_.Latch("objects",
              {"object(keep_out)", "distance(keep_out, 0.3)", "direction(keep_out, 0.1)"});
  EXPECT_THAT(mind_.Decide(), Contains("halt"));
}

TEST_P(AvoidTest, FarEcho_IsNoObject) {
  mind_.Latch("sonar", {"sonar_reading(0, 4.0)"});
  EXPECT_THAT(mind_.Decide(), IsEmpty());
}

TEST_P(AvoidTest, NonsenseFromAbove_RefusedFactByFact) {
  EXPECT_THAT(mind_.Refused("objects", kPushAhead), IsEmpty());
  EXPECT_THAT(mind_.Refused("objects", {"object(p)", "distance(p, -1.0)", "direction(p, 4.0)"}),
              ElementsAre(1, 2));
  EXPECT_THAT(mind_.Refused("objects", {"distance(p, 1.0)", "distance(p, 2.0)"}), ElementsAre(1));
  EXPECT_THAT(mind_.Refused("objects", {"direction(p, -3.141592653589793)", "direction(p, 1.0)",
                                        "direction(p, 1.5)", "direction(q, 1.5)"}),
              ElementsAre(0, 2));
}

TEST_P(AvoidTest, SonarObjectsFromAbove_Refused) {
  mind_.Latch("sonar", {"sonar_reading(0, 0.1)", "no_echo(1)"});
  const std::vector<std::string> claims{
      "distance(sonar_obj(0), 3.0)", "direction(sonar_obj(0), 1.0)", "object(sonar_obj(1))",
      "distance(sonar_obj(1), 3.0)", "direction(sonar_obj(1), 1.5)", "object(sonar_obj(0))"};
  EXPECT_THAT(mind_.Refused("objects", claims), ElementsAre(0, 1, 2, 3, 4));
}

TEST_P(AvoidTest, WhatWasRefusedBefore_DoesNotCount) {
  mind_.Latch("sonar", {"sonar_reading(0, 0.1)"});
  mind_.Decide();
  mind_.Latch("sonar", {"no_echo(0)"});
  EXPECT_THAT(mind_.Refused("objects", {"object(sonar_obj(0))"}), ElementsAre(0));
  mind_.Latch("sonar", {"sonar_reading(0, 0.2)"});
  EXPECT_THAT(mind_.Refused("objects", {"object(sonar_obj(0))"}), IsEmpty());
  mind_.Latch("objects", kPushAhead);
  EXPECT_THAT(mind_.Refused("objects", {"distance(push, 2.0)"}), IsEmpty())
      << "what the latch holds is replaced";
}

}  // namespace
}  // namespace latchwork::test
