// SPDX-License-Identifier: BSD-3-Clause
//
// Why a default was made, what retracted it, and what a goal lacks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/reasoners/circumscription/circumscribing_mind.h"

namespace latchwork::circumscription {
namespace {

constexpr const char* kReflex =
    "fof(ahead, axiom, ! [O, D, G] : ((object(O) & distance(O, D) & gap(G) & $less(D, G))\n"
    "    => halt_robot)).\n"
    "fof(touched, axiom, bumper => halt_robot).\n"
    "fof(go, axiom, ! [V] : ((~ halt_robot & speed(V)) => fwd(V))).\n";

class ExplanationTest : public ::testing::Test {
 protected:
  ExplanationTest() : mind_(kReflex) {
    for (const char* name : {"object", "gap", "speed"}) mind_.Input(name, 1);
    mind_.Input("distance", 2);
    mind_.Input("bumper", 0);
    mind_.Minimize("halt_robot", 0);
    mind_.Goal("fwd(V)");
    mind_.Parameter("mode", "exact");
    mind_.Load();
    mind_.Latch(0, {"speed(0.3)", "gap(0.5)"});
  }

  CircumscribingMind mind_;
};

TEST_F(ExplanationTest, DefaultsAreMadeForWhatClausesLack) {
  mind_.Latch(1, {"object(box)", "distance(box, 0.75)"});
  mind_.Decide();
  const auto explanation = mind_.reasoner.ExplainAssumption(0);
  ASSERT_TRUE(explanation.has_value());
  EXPECT_EQ(ToText(*explanation),
            "nothing concludes halt_robot:\n"
            "  'ahead' has 3 of 4 premises and lacks $less(0.75, 0.5)\n"
            "  'touched' has 0 of 1 premises and lacks bumper\n");
  const std::string expected =
      "{\"subject\":\"halt_robot\",\"holds\":false,\"misses\":["
      "{\"clause\":\"ahead\",\"line\":1,\"met\":3,\"premises\":4,\"lacks\":\"$less(0.75, 0.5)\"},"
      "{\"clause\":\"touched\",\"line\":3,\"met\":0,\"premises\":1,\"lacks\":\"bumper\"}]}";
  EXPECT_EQ(ToJson(*explanation), expected);
}

TEST_F(ExplanationTest, RetractionsNameTheFactsAndPortsBehindThem) {
  mind_.Latch(1, {"object(box)", "distance(box, 0.25)"});
  mind_.Decide();
  const auto explanation = mind_.reasoner.ExplainAssumption(0);
  ASSERT_TRUE(explanation.has_value());
  EXPECT_EQ(ToText(*explanation),
            "halt_robot holds:\n"
            "  object(box)  [latch latch1]\n"
            "  distance(box, 0.25)  [latch latch1]\n"
            "  gap(0.5)  [latch latch0]\n"
            "  halt_robot  [clause ahead]\n");
  EXPECT_THAT(ToJson(*explanation),
              ::testing::HasSubstr("\"kind\":\"latch\",\"source\":\"latch1\""));
}

TEST_F(ExplanationTest, GoalsLackTheNearestPiece) {
  mind_.Latch(1, {"bumper"});
  mind_.Decide();
  const auto explanation = mind_.reasoner.WhyNot(mind_.body.goals[0].pattern);
  ASSERT_TRUE(explanation.has_value());
  EXPECT_EQ(ToText(*explanation),
            "nothing concludes fwd(X0):\n"
            "  'go' has 0 of 2 premises and lacks ~ halt_robot\n");
  mind_.Latch(1, {});
  mind_.Decide();
  EXPECT_TRUE(mind_.reasoner.WhyNot(mind_.body.goals[0].pattern)->holds);
}

TEST_F(ExplanationTest, BoundedDecisionsHaveNone) {
  CircumscribingMind mind(kReflex);
  mind.Goal("fwd(V)");
  mind.Input("speed", 1);
  for (const char* name : {"object", "gap"}) mind.Input(name, 1);
  mind.Input("distance", 2);
  mind.Input("bumper", 0);
  mind.Minimize("halt_robot", 0);
  mind.Parameter("mode", "bounded");
  mind.Load();
  mind.Latch(0, {"speed(0.3)"});
  mind.Decide();
  EXPECT_FALSE(mind.reasoner.ExplainAssumption(0).has_value());
}

}  // namespace
}  // namespace latchwork::circumscription
