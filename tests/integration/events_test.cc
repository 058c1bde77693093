// SPDX-License-Identifier: BSD-3-Clause
//
// What happens to the world while the agent runs: elevators that fail.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::Not;

/// The office agent from the landmark before elevator e1 on floor 1 to that on floor 3, alone in
/// the building, with events.
class EventsTest : public ::testing::Test {
 protected:
  CommandResult RunWith(const std::string& events, const std::string& ticks = "2000") {
    WriteText(folder_.path() / "events.xml", "<fragment format=\"1\">" + events + "</fragment>");
    return RunLatchwork(
        {"run", LATCHWORK_SOURCE_DIR "/examples/office/scenario2.xml", "--scenario", "events.xml",
         "--ticks", ticks, "--set", "world.start=l1_e1", "--set", "world.goal=l3_e1", "--set",
         "world.people=0", "--set", "world.boxes=0", "--out", "out", "--quiet"},
        folder_.path());
  }
  nlohmann::json Summary() const {
    return nlohmann::json::parse(ReadText(folder_.path() / "out/summary.json"));
  }
  std::string Journal() const { return ReadText(folder_.path() / "out/run.journal"); }

 private:
  TemporaryFolder folder_;
};

TEST_F(EventsTest, NothingFails_TakesTheNearElevator) {
  EXPECT_EQ(RunWith("").exit_code, 0);
  EXPECT_EQ(Summary().at("outcome"), "reached");
  EXPECT_THAT(Journal(), HasSubstr("inside(e1)"));
  EXPECT_THAT(Journal(), Not(HasSubstr("inside(e2)")));
}

TEST_F(EventsTest, ElevatorFailsWhileTheRobotWaits_TakesTheOther) {
  const CommandResult result = RunWith("<event at=\"3s\" fact=\"out_of_order(e1)\"/>");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Summary().at("outcome"), "reached");
  EXPECT_EQ(Summary().at("collisions"), 0);
  EXPECT_THAT(Journal(), HasSubstr("\"events\":[{\"fact\":\"out_of_order(e1)\""));
  EXPECT_THAT(Journal(), HasSubstr("elevator_out_of_order(e1)"));
  EXPECT_THAT(Journal(), HasSubstr("inside(e2)"));
  EXPECT_THAT(Journal(), Not(HasSubstr("inside(e1)")));
}

TEST_F(EventsTest, ElevatorFailsUnderWay_LetsTheRobotOutAndItTakesTheOther) {
  const CommandResult result = RunWith("<event at=\"28s\" fact=\"out_of_order(e1)\"/>");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Summary().at("outcome"), "reached");
  EXPECT_EQ(Summary().at("collisions"), 0);
  EXPECT_THAT(Journal(), HasSubstr("\"elevator_out_of_order(e1)\",\"inside(e1)\""));
  EXPECT_THAT(Journal(), HasSubstr("curr_landmark(l2_e1)"));
  EXPECT_THAT(Journal(), HasSubstr("inside(e2)"));
}

TEST_F(EventsTest, BothElevatorsFail_WaitsAndSaysSo) {
  const CommandResult result = RunWith(
      "<event at=\"3s\" fact=\"out_of_order(e1)\"/><event at=\"3s\" fact=\"out_of_order(e2)\"/>",
      "600");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(Summary().at("outcome"), "not reached");
  EXPECT_EQ(Summary().at("ticks"), 600);
  EXPECT_EQ(Summary().at("collisions"), 0);
  EXPECT_LT(Summary().at("measures").at("distance_m").get<double>(), 1.0);
  EXPECT_THAT(Journal(), Not(HasSubstr("inside(")));
}

TEST_F(EventsTest, ElevatorWorksAgain_IsTaken) {
  const CommandResult result = RunWith(
      "<event at=\"3s\" fact=\"out_of_order(e1)\"/><event at=\"3s\" fact=\"out_of_order(e2)\"/>"
      "<event at=\"30s\" fact=\"in_service(e1)\"/>");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Summary().at("outcome"), "reached");
  EXPECT_THAT(Journal(), HasSubstr("inside(e1)"));
}

TEST_F(EventsTest, UnknownElevator_IsTold) {
  const CommandResult result = RunWith("<event at=\"1s\" fact=\"out_of_order(e9)\"/>", "50");
  EXPECT_THAT(result.out,
              HasSubstr("event at tick 10: out_of_order(e9): not done: the building has "
                        "no elevator 'e9'\n"));
  const nlohmann::json event = Summary().at("events").at(0);
  EXPECT_EQ(event.at("tick"), 10);
  EXPECT_EQ(event.at("fact"), "out_of_order(e9)");
  EXPECT_EQ(event.at("problem"), "the building has no elevator 'e9'");
}

}  // namespace
}  // namespace latchwork::testing
