// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

#include "latchwork/sdk/random.h"
#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

using ::testing::UnorderedElementsAreArray;

/// Two floors with a lobby between two elevators.
const std::vector<std::string> kBuilding{"landmark(m1, 1, 0.0, 1.0)",
                                         "landmark(f11, 1, 1.0, 1.0)",
                                         "landmark(f12, 1, 2.0, 1.0)",
                                         "landmark(m2, 2, 0.0, 2.0)",
                                         "landmark(f21, 2, 1.0, 2.0)",
                                         "landmark(f22, 2, 2.0, 2.0)",
                                         "landmark(c1, 0, 1.0, 9.0)",
                                         "landmark(c2, 0, 2.0, 9.0)",
                                         "adjacent(m1, f11)",
                                         "adjacent(f11, m1)",
                                         "adjacent(m1, f12)",
                                         "adjacent(f12, m1)",
                                         "adjacent(m2, f21)",
                                         "adjacent(f21, m2)",
                                         "adjacent(m2, f22)",
                                         "adjacent(f22, m2)",
                                         "elevator(e1)",
                                         "elevator(e2)",
                                         "elevator_front(e1, f11, 1)",
                                         "elevator_front(e1, f21, 2)",
                                         "elevator_front(e2, f12, 1)",
                                         "elevator_front(e2, f22, 2)",
                                         "cab(e1, c1)",
                                         "cab(e2, c2)"};

struct Case {
  std::string name;
  std::string at;
  std::string target;
  std::vector<std::string> elevators;
  std::vector<std::string> expected;
};

class ElevatorsTest : public ::testing::TestWithParam<Case> {
 protected:
  void ExpectNextStep(std::string_view reasoner);
};

void ElevatorsTest::ExpectNextStep(std::string_view reasoner) {
  LayerMind mind("elevators", {}, reasoner);
  mind.Latch("building", kBuilding);
  mind.Latch("place", {"curr_landmark(" + GetParam().at + ")"});
  mind.Latch("elevators", GetParam().elevators);
  if (!GetParam().target.empty()) {
    mind.Latch("target", {"target_landmark(" + GetParam().target + ")"});
  }
  EXPECT_THAT(mind.Decide(), UnorderedElementsAreArray(GetParam().expected));
}

TEST_P(ElevatorsTest, Situation_NextStepOfTheTheory) { ExpectNextStep("pttp"); }
TEST_P(ElevatorsTest, Situation_NextStepOfTheProgram) { ExpectNextStep("icarus"); }

/// Every place and target with the elevators in states of all kinds.
TEST(ElevatorsAgreementTest, ProgramAndTheory_ConcludeTheSame) {
  LayerMind theory("elevators");
  LayerMind program("elevators", {}, kIcarusMind);
  const sdk::RandomStream random(5, "situations");
  const auto pick = [&](const std::vector<std::string>& from, std::uint64_t a, std::uint64_t b) {
    return from[random.Index(from.size(), a, b)];
  };
  const std::vector<std::string> floors{"m1", "f11", "f12", "m2", "f21", "f22"};
  std::size_t speaking = 0;
  for (std::uint64_t i = 0; i < 600; ++i) {
    std::vector<std::string> elevators;
    std::string at = pick(floors, i, 0);
    for (const std::string e : {"e1", "e2"}) {
      const std::uint64_t number = e == "e1" ? 10 : 20;
      elevators.push_back("elevator_at(" + e + ", " + pick({"1", "2"}, i, number) + ")");
      if (random.Index(2, i, number + 1) == 0) elevators.push_back("elevator_open(" + e + ")");
      if (random.Index(4, i, number + 2) == 0) {
        elevators.push_back("elevator_out_of_order(" + e + ")");
      }
    }
    if (random.Index(3, i, 1) == 0) {
      at = "c1";
      if (random.Index(3, i, 2) != 0) elevators.push_back("inside(e1)");
    }
    const std::string target = pick(floors, i, 3);
    for (LayerMind* mind : {&theory, &program}) {
      mind->Latch("building", kBuilding);
      mind->Latch("place", {"curr_landmark(" + at + ")"});
      mind->Latch("elevators", elevators);
      mind->Latch("target", {"target_landmark(" + target + ")"});
    }
    const auto expected = theory.Decide();
    EXPECT_EQ(program.Decide(), expected)
        << at << " to " << target << ::testing::PrintToString(elevators);
    if (!expected.empty()) ++speaking;
  }
  EXPECT_GT(speaking, 300U);
}

INSTANTIATE_TEST_SUITE_P(
    DecisionTable, ElevatorsTest,
    ::testing::Values(
        Case{"NoTarget", "m1", "", {"elevator_at(e1, 1)", "elevator_at(e2, 1)"}, {}},
        Case{"NextRoom",
             "m1",
             "f11",
             {"elevator_at(e1, 2)", "elevator_at(e2, 1)"},
             {"move_cmd(1.0, 1.0)"}},
        Case{"AtTheTarget",
             "m1",
             "m1",
             {"elevator_at(e1, 2)", "elevator_at(e2, 1)"},
             {"move_cmd(0.0, 1.0)"}},
        Case{"ElevatorElsewhere",
             "f11",
             "f21",
             {"elevator_at(e1, 2)", "elevator_at(e2, 2)"},
             {"call(e1, 1)", "move_cmd(1.0, 1.0)"}},
        Case{"ElevatorHereButShut",
             "f11",
             "f21",
             {"elevator_at(e1, 1)", "elevator_at(e2, 2)"},
             {"call(e1, 1)", "move_cmd(1.0, 1.0)"}},
        Case{"ElevatorOpen",
             "f11",
             "f21",
             {"elevator_at(e1, 1)", "elevator_open(e1)", "elevator_at(e2, 2)"},
             {"move_cmd(1.0, 9.0)"}},
        Case{"InTheCab",
             "c1",
             "f21",
             {"elevator_at(e1, 1)", "elevator_open(e1)", "inside(e1)", "elevator_at(e2, 2)"},
             {"move_cmd(1.0, 9.0)", "ride(e1, 2)"}},
        Case{"ArrivedDoorShut",
             "c1",
             "f21",
             {"elevator_at(e1, 2)", "inside(e1)", "elevator_at(e2, 2)"},
             {"move_cmd(1.0, 9.0)"}},
        Case{"ArrivedDoorOpen",
             "c1",
             "f21",
             {"elevator_at(e1, 2)", "elevator_open(e1)", "inside(e1)", "elevator_at(e2, 2)"},
             {"move_cmd(1.0, 2.0)"}},
        Case{"OutButNotYetThere",
             "c1",
             "f21",
             {"elevator_at(e1, 1)", "elevator_at(e2, 2)"},
             {"move_cmd(1.0, 2.0)"}},
        Case{"OutOfOrder",
             "f11",
             "f21",
             {"elevator_at(e1, 1)", "elevator_open(e1)", "elevator_out_of_order(e1)",
              "elevator_at(e2, 2)"},
             {}},
        Case{"StuckInTheCab",
             "c1",
             "f11",
             {"elevator_at(e1, 1)", "elevator_open(e1)", "inside(e1)", "elevator_out_of_order(e1)",
              "elevator_at(e2, 2)"},
             {"move_cmd(1.0, 1.0)"}}),
    [](const auto& situation) { return situation.param.name; });

}  // namespace
}  // namespace latchwork::test
