// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// One car, in an arena whose poles are far away; the agent stands in the middle and looks along
/// the x axis.
class BumperDriverTest : public ::testing::TestWithParam<const char*> {
 protected:
  explicit BumperDriverTest(const char* plan = GetParam())
      : mind_("bumper_driver", {{"plan", plan, {}}}, kIcarusMind) {
    mind_.Latch("task",
                {"task(collision)", "today(monday)", "spills_wanted(1)", "thrills_wanted(1)"});
    mind_.Latch("places", {"pole(pole1, 1.0, 1.0)", "gate(1.2, 5.0)"});
    mind_.Latch("feelers", {"clear(ahead, 7.0)", "clear(left, 5.0)", "clear(right, 5.0)"});
    Driver("enemy(anna)");
    Self("0.0");
    Score({});
  }
  void Driver(const std::string& attitude) {
    mind_.Latch("people", {"driver(car1, anna)", attitude});
  }
  void Self(const std::string& speed, const std::string& power = "on") {
    mind_.Latch("self", {"pose(8.0, 5.0, 0.0)", "speed(" + speed + ")", "power(" + power + ")"});
  }
  void See(const std::string& distance, const std::string& bearing) {
    mind_.Latch("eyes", {"sees(car1, " + distance + ", " + bearing + ")"});
  }
  void Score(std::vector<std::string> facts) {
    facts.insert(facts.end(), {"spill_count(0)", "thrill_count(0)"});
    mind_.Latch("score", facts);
  }
  std::string Pedal() { return mind_.Decide().at(0); }
  std::string Steer() { return mind_.Decide().at(1); }

  LayerMind mind_;
};

/// What does not depend on the form of the plan.
class BumperRulesTest : public BumperDriverTest {
 protected:
  BumperRulesTest() : BumperDriverTest("skill") {}
};

TEST_P(BumperDriverTest, EnemyBehind_IsLookedFor) {
  mind_.Latch("eyes", {});
  EXPECT_THAT(mind_.Decide(), ElementsAre("pedal(40)", "steer(1.0)"));
}

TEST_P(BumperDriverTest, EnemyAside_TurnsToIt) {
  See("6.0", "0.5");
  EXPECT_EQ(Pedal(), "pedal(40)");
  EXPECT_THAT(Steer(), AnyOf(StartsWith("steer(1.0"), StartsWith("steer(0.99")));
}

TEST_P(BumperDriverTest, EnemyFarAhead_DrivesThere) {
  See("6.0", "0.1");
  EXPECT_EQ(Pedal(), "pedal(70)");
}

TEST_P(BumperDriverTest, EnemyNear_IsRammed) {
  See("1.6", "0.1");
  EXPECT_EQ(Pedal(), "pedal(100)");
}

TEST_P(BumperDriverTest, FriendNear_IsTapped) {
  Driver("friend(anna)");
  See("1.6", "0.1");
  EXPECT_EQ(Pedal(), "pedal(20)");
}

TEST_P(BumperDriverTest, OutOfSightLately_DrivesToWhereItWas) {
  See("6.0", "-0.45");
  mind_.Cycle();
  mind_.Latch("eyes", {});
  EXPECT_EQ(Pedal(), "pedal(40)");
  EXPECT_THAT(Steer(), AnyOf(StartsWith("steer(-0.9"), StartsWith("steer(-0.89")));
}

INSTANTIATE_TEST_SUITE_P(Plans, BumperDriverTest, ::testing::Values("skill", "tree", "universal"),
                         [](const auto& test) { return std::string(test.param); });

TEST_F(BumperRulesTest, EnemyRammed_NothingToDo) {
  See("1.6", "0.1");
  Score({"rammed(car1)"});
  EXPECT_THAT(mind_.Decide(), IsEmpty());
}

TEST_F(BumperRulesTest, Stranger_IsLeftAlone) {
  Driver("friend(bob)");
  See("1.6", "0.1");
  EXPECT_THAT(mind_.Decide(), IsEmpty());
}

TEST_F(BumperRulesTest, FriendCloseAndTooFast_Brakes) {
  Driver("friend(anna)");
  Self("1.5");
  See("2.0", "0.4");
  EXPECT_EQ(Pedal(), "pedal(-60)");
}

TEST_F(BumperRulesTest, NoPower_GoesToThePole) {
  Self("0.0", "off");
  See("1.6", "0.1");
  EXPECT_EQ(Pedal(), "pedal(40)");
  EXPECT_THAT(Steer(), StartsWith("steer(-5."));  // behind, to the right
}

TEST_F(BumperRulesTest, WallAhead_BacksOffForAWhile) {
  See("6.0", "0.1");
  mind_.Latch("feelers", {"clear(ahead, 0.05)", "clear(left, 5.0)", "clear(right, 1.0)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("pedal(-30)", "steer(-0.8)"));
  mind_.Latch("feelers", {"clear(ahead, 0.5)", "clear(left, 5.0)", "clear(right, 1.0)"});
  for (int i = 0; i < 15; ++i) EXPECT_EQ(Pedal(), "pedal(-30)");
  EXPECT_EQ(Pedal(), "pedal(70)");
}

TEST_F(BumperRulesTest, PoleInTheWay_IsPassed) {
  mind_.Latch("places", {"pole(pole1, 9.5, 4.9)", "gate(1.2, 5.0)"});
  See("6.0", "0.1");
  EXPECT_EQ(Pedal(), "pedal(50)");
  EXPECT_EQ(Steer(), "steer(1.0)");
}

TEST_F(BumperRulesTest, Day_IsPaidRiddenAndLeft) {
  mind_.Latch("task", {"task(day)", "today(monday)", "spills_wanted(1)", "thrills_wanted(1)"});
  See("1.6", "0.1");
  EXPECT_THAT(mind_.Decide(), ElementsAre("pay"));
  Score({"paid"});
  EXPECT_EQ(Pedal(), "pedal(100)");  // a spill
  mind_.Latch("eyes", {});
  mind_.Latch("score", {"paid", "spill_count(1)", "thrill_count(0)"});
  EXPECT_EQ(Pedal(), "pedal(100)");  // a thrill
  mind_.Latch("score", {"paid", "spill_count(1)", "thrill_count(1)"});
  EXPECT_EQ(Pedal(), "pedal(70)");  // laps until the bell
  mind_.Latch("score", {"paid", "ride_over", "spill_count(1)", "thrill_count(1)"});
  EXPECT_EQ(Pedal(), "pedal(40)");  // to the gate, behind
  mind_.Latch("places", {"pole(pole1, 1.0, 1.0)", "gate(8.2, 5.0)"});
  Self("0.5");
  EXPECT_EQ(Pedal(), "pedal(0)");
  Self("0.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("leave"));
}

}  // namespace
}  // namespace latchwork::test
