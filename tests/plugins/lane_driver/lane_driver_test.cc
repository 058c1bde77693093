// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

using ::testing::ElementsAre;

/// A road of three lanes with a limit of 30 m/s.
class LaneDriverTest : public ::testing::Test {
 protected:
  explicit LaneDriverTest(std::vector<sdk::Parameters::Given> parameters = {})
      : mind_("lane_driver", std::move(parameters), kIcarusMind) {
    mind_.Latch("road", {"lane(0)", "lane(1)", "lane(2)", "left_of(1, 0)", "left_of(2, 1)",
                         "speed_limit(30.0)"});
    See({});
    In("1");
  }
  void See(const std::vector<std::string>& cars) { mind_.Latch("cars", cars); }
  /// In the middle of a lane, at the limit.
  void In(const std::string& lane, const std::string& exit = "1200.0",
          const std::string& speed = "30.0") {
    Between(lane, lane, "0.0", exit, speed);
  }
  void Between(const std::string& lane, const std::string& aim, const std::string& offset,
               const std::string& exit = "1200.0", const std::string& speed = "30.0") {
    std::vector<std::string> self = {"my_lane(" + lane + ")",     "my_aim(" + aim + ")",
                                     "my_offset(" + offset + ")", "in_lane(" + lane + ")",
                                     "my_speed(" + speed + ")",   "exit_in(" + exit + ")"};
    if (aim != lane) self.push_back("in_lane(" + aim + ")");
    mind_.Latch("self", self);
  }
  /// The lane that is aimed at.
  std::string Aim() { return mind_.Decide().at(1); }
  double Acceleration() {
    const std::string text = mind_.Decide().at(0);
    return std::stod(text.substr(text.find('(') + 1));
  }
  LayerMind mind_;
};

class FreeLaneDriverTest : public LaneDriverTest {
 protected:
  FreeLaneDriverTest() : LaneDriverTest({{"passing", "free", {}}}) {}
};

TEST_F(LaneDriverTest, EmptyRoad_CruisesAtTheLimit) {
  EXPECT_THAT(mind_.Decide(), ElementsAre("accelerate(0.0)", "aim(1)"));
  In("1", "1200.0", "20.0");
  EXPECT_EQ(Acceleration(), 1.5);
}

TEST_F(LaneDriverTest, CarAheadAsFast_IsFollowedAtTheHeadway) {
  See({"ahead(1, car7, 39.0, 0.0)"});
  EXPECT_NEAR(Acceleration(), 0, 1e-9);
  See({"ahead(1, car7, 30.0, 0.0)"});
  EXPECT_LT(Acceleration(), -0.5);
}

TEST_F(LaneDriverTest, StandingCarClose_EmergencyBrake) {
  See({"ahead(1, car7, 40.0, -30.0)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("accelerate(-8.0)", "aim(1)"));
}

TEST_F(LaneDriverTest, SlowCarFarEnough_IsEvaded_UnlessTheExitIsNear) {
  See({"ahead(1, car7, 90.0, -20.0)", "ahead(2, car8, 60.0, -1.0)"});
  EXPECT_EQ(Aim(), "aim(2)");
  In("1", "500.0");
  EXPECT_EQ(Aim(), "aim(0)");
}

TEST_F(LaneDriverTest, FastestLane_IsTaken) {
  See({"ahead(1, car1, 50.0, -6.0)", "ahead(2, car2, 60.0, -4.0)", "ahead(0, car3, 70.0, -2.0)"});
  EXPECT_EQ(Aim(), "aim(0)");
  See({"ahead(1, car1, 50.0, -6.0)", "ahead(2, car2, 60.0, -1.0)", "ahead(0, car3, 70.0, -2.0)"});
  EXPECT_EQ(Aim(), "aim(2)");
  See({"ahead(1, car1, 50.0, -3.0)", "ahead(2, car2, 60.0, -5.0)", "ahead(0, car3, 70.0, -4.0)"});
  EXPECT_EQ(Aim(), "aim(1)");
}

TEST_F(LaneDriverTest, FastestLaneWithoutRoom_IsNot) {
  const std::vector<std::string> cars = {"ahead(1, car1, 50.0, -6.0)",
                                         "ahead(0, car3, 70.0, -9.0)"};
  for (const std::string blocked :
       {"beside(2, car2)", "behind(2, car2, 8.0, 0.0)", "behind(2, car2, 40.0, 15.0)"}) {
    See({cars[0], cars[1], blocked});
    EXPECT_EQ(Aim(), "aim(1)") << blocked;
  }
  See({cars[0], cars[1], "behind(2, car2, 40.0, 1.0)"});
  EXPECT_EQ(Aim(), "aim(2)");
}

TEST_F(LaneDriverTest, BetweenLanes_GoesOn_OrTurnsBackWhenTheLaneIsTaken) {
  Between("1", "2", "1.0");
  EXPECT_EQ(Aim(), "aim(2)");
  See({"beside(2, car2)"});
  EXPECT_EQ(Aim(), "aim(1)");
}

TEST_F(LaneDriverTest, BetweenLanes_MindsTheSlowerOfBoth) {
  Between("1", "2", "1.0");
  See({"ahead(1, car1, 20.0, 0.0)"});
  const double first = Acceleration();
  See({"ahead(1, car1, 20.0, 0.0)", "ahead(2, car2, 30.0, -5.0)"});
  EXPECT_LT(Acceleration(), first);
}

TEST_F(LaneDriverTest, NearTheExit_GoesRightAndStaysThere) {
  In("2", "700.0");
  EXPECT_EQ(Aim(), "aim(1)");
  In("1", "500.0");
  EXPECT_EQ(Aim(), "aim(0)");
  In("0", "250.0");
  See({"ahead(0, car1, 50.0, -6.0)"});
  EXPECT_EQ(Aim(), "aim(0)");
}

TEST_F(LaneDriverTest, NearTheExit_NoRoom_FallsBack) {
  In("1", "500.0");
  See({"beside(0, car1)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("accelerate(-1.5)", "aim(1)"));
}

TEST_F(FreeLaneDriverTest, SlowCar_LeftIsTriedBeforeRightBeforeStaying) {
  const std::string slow = "ahead(1, car1, 50.0, -6.0)";
  See({slow});
  EXPECT_EQ(Aim(), "aim(2)");
  See({slow, "beside(2, car2)"});
  EXPECT_EQ(Aim(), "aim(0)");
  See({slow, "beside(2, car2)", "beside(0, car3)"});
  EXPECT_EQ(Aim(), "aim(1)");
}

}  // namespace
}  // namespace latchwork::test
