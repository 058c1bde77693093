// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/brooks/brooks_reasoner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "latchwork/logic/tptp.h"
#include "latchwork/sdk/contract_body.h"

namespace latchwork::brooks {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;
using Facts = std::vector<std::string>;

/// The behaviour for a contract that names what goes out: facts in, sorted acts out, as texts.
class Robot {
 public:
  Robot(const Facts& conclusions, std::vector<sdk::Parameters::Given> given = {}) {
    sdk::PortSpec out{.name = "out", .predicates = {}, .help = ""};
    for (const std::string& text : conclusions) {
      const logic::Fact shape = Read(text);
      out.predicates.push_back({std::string(shape.predicate().name()),
                                std::vector<sdk::ArgumentSpec>(shape.arity()), ""});
    }
    const sdk::Body body = sdk::ContractBody({{}, {out}}, "", symbols_);
    const auto parameters =
        sdk::Parameters::Check(reasoner_.parameters(), given, "brooks", {}, diagnostics_);
    const auto refused = reasoner_.Load(body, parameters, symbols_);
    diagnostics_.insert(diagnostics_.end(), refused.begin(), refused.end());
  }

  Facts Act(const Facts& facts) {
    std::vector<sdk::Latch> latches(1);
    for (const std::string& text : facts) latches[0].facts.push_back(Read(text));
    reasoner_.Decide(latches, {}, decision_);
    Facts acts;
    for (const auto& conclusion : decision_.conclusions) {
      acts.push_back(logic::ToString(conclusion.fact));
    }
    std::sort(acts.begin(), acts.end());
    return acts;
  }
  sdk::Status status() const { return decision_.status; }
  const logic::Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  logic::Fact Read(const std::string& text) {
    const auto read = logic::ReadTptpAtom(text, "test", symbols_);
    EXPECT_TRUE(read.atom.has_value()) << text;
    return read.atom.value_or(logic::Fact());
  }

  logic::SymbolTable symbols_;
  BrooksReasoner reasoner_;
  sdk::Decision decision_;
  logic::Diagnostics diagnostics_;
};

const Facts kAvoid{"fwd(v)", "turn(a)", "halt"};
const Facts kSeek{"object(o)", "distance(o, d)", "direction(o, a)"};

/// Eight sonars, the first ahead, and a push from behind.
Facts Pushed(Facts more) {
  more.insert(more.end(), {"robot_radius(0.25)", "object(p)", "distance(p, 1.0)",
                           "direction(p, 3.141592653589793)"});
  for (int i = 0; i < 8; ++i) {
    const double angle = i <= 4 ? 0.7854 * i : 0.7854 * (i - 8);
    more.push_back("sonar_direction(" + std::to_string(i) + ", " + std::to_string(angle) + ")");
  }
  return more;
}

double Angle(const Facts& acts) {
  for (const std::string& act : acts) {
    if (act.starts_with("turn(")) return std::strtod(act.c_str() + 5, nullptr);
  }
  return 0.0;
}

TEST(BrooksAvoidTest, NothingNear_StraightOnAtFullSpeed) {
  Robot robot(kAvoid);
  const Facts acts = robot.Act(Pushed({}));
  ASSERT_THAT(acts, ElementsAre(StartsWith("fwd(")));
  EXPECT_NEAR(std::strtod(acts[0].c_str() + 4, nullptr), 0.6, 1e-9);
}

TEST(BrooksAvoidTest, NothingToDo_Silent) {
  Robot robot(kAvoid);
  EXPECT_THAT(robot.Act({"robot_radius(0.25)"}), IsEmpty());
  EXPECT_EQ(robot.status(), sdk::Status::kRefuted);
}

TEST(BrooksAvoidTest, BoxAhead_TurnsAside) {
  Robot robot(kAvoid);
  const Facts acts = robot.Act(Pushed({"sonar_reading(0, 0.5)", "sonar_reading(1, 0.5)"}));
  EXPECT_LT(Angle(acts), -0.3) << "away from the side on which it lies";
  EXPECT_THAT(robot.Act(Pushed({"sonar_reading(0, 0.5)", "sonar_reading(7, 0.5)"})),
              Contains(StartsWith("turn(")));
}

TEST(BrooksAvoidTest, CloseAhead_HaltsAndTurnsButDoesNotGo) {
  Robot robot(kAvoid);
  const Facts acts = robot.Act(Pushed({"sonar_reading(0, 0.1)"}));
  ASSERT_THAT(acts, SizeIs(2));
  EXPECT_EQ(acts[0], "halt");
  EXPECT_THAT(acts[1], StartsWith("turn("));
}

TEST(BrooksAvoidTest, WallFarAhead_Slower) {
  Robot robot(kAvoid);
  const Facts acts = robot.Act(Pushed({"sonar_reading(0, 0.8)"}));
  ASSERT_THAT(acts[0], StartsWith("fwd("));
  EXPECT_LT(std::strtod(acts[0].c_str() + 4, nullptr), 0.6);
}

TEST(BrooksAvoidTest, Wandering_TurnsNowAndThenTheSameWithTheSameSeed) {
  Facts first;
  Facts second;
  for (Facts* turns : {&first, &second}) {
    Robot robot(kAvoid, {{"wander", "true", {}}, {"whim", "10", {}}});
    for (int i = 0; i < 100; ++i) {
      for (const std::string& act : robot.Act({"robot_radius(0.25)"})) {
        if (act.starts_with("turn(")) turns->push_back(act);
      }
    }
  }
  EXPECT_THAT(first, SizeIs(10));
  EXPECT_EQ(first, second);
}

TEST(BrooksSeekTest, Destination_PushedFromTheOtherSide) {
  Robot robot(kSeek);
  EXPECT_THAT(robot.Act({"curr_location(1.0, 1.0)", "curr_heading(0.0)", "move_cmd(1.0, 5.0)"}),
              ElementsAre(StartsWith("direction(push_object, -1.5707"),
                          "distance(push_object, 1.0)", "object(push_object)"));
}

TEST(BrooksSeekTest, Reached_SilentEvenWhereItExplores) {
  Robot robot(kSeek, {{"wander", "true", {}}});
  EXPECT_THAT(robot.Act({"curr_location(1.0, 1.0)", "curr_heading(0.0)", "move_cmd(1.1, 1.0)"}),
              IsEmpty());
}

TEST(BrooksSeekTest, NoDestination_ExploresOnlyWhereToldTo) {
  const Facts pose{"curr_location(1.0, 1.0)", "curr_heading(0.0)"};
  EXPECT_THAT(Robot(kSeek).Act(pose), IsEmpty());
  EXPECT_THAT(Robot(kSeek, {{"wander", "true", {}}}).Act(pose), SizeIs(3));
}

TEST(BrooksReasonerTest, LayerOfAnotherKind_Refused) {
  EXPECT_THAT(Robot({"target_landmark(l)"}).diagnostics(), SizeIs(1));
}

}  // namespace
}  // namespace latchwork::brooks
