// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::array<const char*, 3> kPegs{"left", "middle", "right"};

/// Disks on pegs 0, 1, 2, from the smallest; -1 is in the gripper.
class HanoiPlayerTest : public ::testing::Test {
 protected:
  void Task(std::size_t disks) {
    mind_.Latch("task", {"disks(" + std::to_string(disks) + ")", "peg(left)", "peg(middle)",
                         "peg(right)", "target(right)"});
  }
  void Camera(const std::vector<int>& peg_of) {
    std::vector<std::string> facts;
    std::array<bool, 3> covered{};
    for (std::size_t i = 0; i < peg_of.size(); ++i) {
      if (peg_of[i] < 0) continue;
      const auto peg = static_cast<std::size_t>(peg_of[i]);
      const std::string disk = std::to_string(i + 1);
      facts.push_back("on_peg(" + disk + ", " + kPegs[peg] + ")");
      if (!covered[peg]) facts.push_back("topmost(" + std::string(kPegs[peg]) + ", " + disk + ")");
      covered[peg] = true;
    }
    mind_.Latch("camera", facts);
  }
  void Gripper(const std::vector<std::string>& facts) { mind_.Latch("gripper", facts); }

  LayerMind mind_{"hanoi_player", {}, kIcarusMind};
};

TEST_F(HanoiPlayerTest, TowerOnTheTarget_NothingToDo) {
  Task(3);
  Camera({2, 2, 2});
  Gripper({"above(left)", "raised"});
  EXPECT_THAT(mind_.Decide(), IsEmpty());
}

TEST_F(HanoiPlayerTest, OneDisk_IsFetchedAndBrought) {
  Task(1);
  Camera({0});
  Gripper({"above(middle)", "raised"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("move_to(left)"));
  Gripper({"above(left)", "raised"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("lower"));
  Gripper({"above(left)", "down"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("grasp"));
  Camera({-1});
  Gripper({"above(left)", "down", "holds(1)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("raise"));
  Gripper({"above(left)", "raised", "holds(1)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("move_to(right)"));
  Gripper({"above(right)", "raised", "holds(1)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("lower"));
  Gripper({"above(right)", "down", "holds(1)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("release"));
}

TEST_F(HanoiPlayerTest, PegTakenBySmallerDiskMeanwhile_PutsTheDiskAside) {
  Task(2);
  Camera({2, -1});
  Gripper({"above(right)", "raised", "holds(2)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("move_to(left)"));
}

TEST_F(HanoiPlayerTest, DiskMovedWhileLowered_RaisesAndGoesThere) {
  Task(1);
  Camera({1});
  Gripper({"above(left)", "down"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("raise"));
}

/// Plays with a gripper that does what it is told at once, from every position there is.
TEST_F(HanoiPlayerTest, AnyPositionOfFiveDisks_TakesTheLeastMoves) {
  Task(5);
  for (int start = 0; start < 243; ++start) {
    std::vector<int> peg_of;
    int least = 0;
    for (int code = start, i = 0; i < 5; ++i, code /= 3) peg_of.push_back(code % 3);
    for (int target = 2, i = 4; i >= 0; --i) {
      const int peg = peg_of[static_cast<std::size_t>(i)];
      if (peg == target) continue;
      least += 1 << i;
      target = 3 - peg - target;
    }
    int moves = 0;
    int held = 0;
    int above = 0;
    bool raised = true;
    for (int cycle = 0; cycle < 400; ++cycle) {
      Camera(peg_of);
      std::vector<std::string> gripper{
          "above(" + std::string(kPegs[static_cast<std::size_t>(above)]) + ")",
          raised ? "raised" : "down"};
      if (held != 0) gripper.push_back("holds(" + std::to_string(held) + ")");
      Gripper(gripper);
      const std::vector<std::string> acts = mind_.Decide();
      if (acts.empty()) break;
      ASSERT_EQ(acts.size(), 1U);
      if (acts[0] == "raise") raised = true;
      if (acts[0] == "lower") raised = false;
      if (acts[0] == "move_to(left)") above = 0;
      if (acts[0] == "move_to(middle)") above = 1;
      if (acts[0] == "move_to(right)") above = 2;
      const auto top = std::find(peg_of.begin(), peg_of.end(), above);
      if (acts[0] == "grasp") {
        ASSERT_NE(top, peg_of.end());
        held = static_cast<int>(top - peg_of.begin()) + 1;
        *top = -1;
      }
      if (acts[0] == "release") {
        ASSERT_TRUE(top == peg_of.end() || top - peg_of.begin() + 1 > held);
        peg_of[static_cast<std::size_t>(held) - 1] = above;
        held = 0;
        ++moves;
      }
    }
    EXPECT_THAT(peg_of, testing::Each(2)) << start;
    EXPECT_EQ(moves, least) << start;
  }
}

}  // namespace
}  // namespace latchwork::test
