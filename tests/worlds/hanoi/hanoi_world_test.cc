// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/hanoi/hanoi_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/temporary_folder.h"

namespace latchwork::hanoi {
namespace {

using logic::Fact;
using logic::Term;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class HanoiWorldTest : public ::testing::Test {
 protected:
  logic::Diagnostics Load(const std::vector<std::pair<std::string, std::string>>& values,
                          std::uint64_t seed = 1) {
    std::vector<sdk::Parameters::Given> given;
    for (const auto& [name, value] : values) given.push_back({name, value, {"agent.xml", 3, 5}});
    logic::Diagnostics diagnostics;
    const auto parameters = sdk::Parameters::Check(world_.parameters(), given, "hanoi",
                                                   {"agent.xml", 2, 1}, diagnostics);
    if (!diagnostics.empty()) return diagnostics;
    tick_ = 0;
    return world_.Load({seed, 0.1, {}, &symbols_}, parameters);
  }

  /// Ticks with the same command, until the position or the gripper's stand changes, or `most`.
  void Do(const std::string& name, const std::string& peg = {}, int most = 1) {
    std::vector<Fact> facts;
    if (peg.empty()) {
      facts.emplace_back(symbols_.Intern(name));
    } else {
      facts.emplace_back(symbols_.Intern(name),
                         std::initializer_list<Term>{Term::Constant(symbols_.Intern(peg))});
    }
    const std::vector<sdk::Batch> effectors{{true, facts}};
    for (int i = 0; i < most; ++i) {
      world_.Observe(tick_, sensors_);
      world_.Apply(tick_, effectors);
      world_.Step(tick_++);
    }
  }

  void Carry(const std::string& from, const std::string& to) {
    for (const auto& [name, peg] :
         std::vector<std::pair<std::string, std::string>>{{"raise", ""},
                                                          {"move_to", from},
                                                          {"lower", ""},
                                                          {"grasp", ""},
                                                          {"raise", ""},
                                                          {"move_to", to},
                                                          {"lower", ""},
                                                          {"release", ""}}) {
      const int ticks = name == "grasp" || name == "release" ? 3 : 15;
      Do(name, peg, ticks);
    }
  }

  std::string Sensed(SensorPort port) {
    world_.Observe(tick_, sensors_);
    std::string text;
    for (const Fact& fact : sensors_[port].facts) text += logic::ToString(fact) + " ";
    return text;
  }

  logic::Diagnostics Event(std::int64_t disk, const std::string& peg) {
    return world_.HandleEvent(tick_,
                              Fact(symbols_.Intern("hand_moves"),
                                   {Term::Integer(disk), Term::Constant(symbols_.Intern(peg))}));
  }
  double Measure(const std::string& name) const {
    for (const auto& [measure, value] : world_.Measures()) {
      if (measure == name) return value;
    }
    ADD_FAILURE() << name;
    return 0;
  }

  logic::SymbolTable symbols_;
  HanoiWorld world_;
  std::vector<sdk::Batch> sensors_ = std::vector<sdk::Batch>(kSensorPorts);
  std::uint64_t tick_ = 0;
};

TEST(PegsTest, TopIsTheSmallestDiskOfAPeg) {
  const Pegs pegs({2, 0, 2});
  EXPECT_EQ(pegs.Top(0), 2);
  EXPECT_EQ(pegs.Top(1), 0);
  EXPECT_EQ(pegs.Top(2), 1);
  EXPECT_EQ(pegs.Count(2), 2);
  EXPECT_TRUE(pegs.Takes(0, 1));
  EXPECT_FALSE(pegs.Takes(0, 3));
}

TEST(PegsTest, LeastMovesOfATowerAreTwoToTheDisksLessOne) {
  EXPECT_EQ(LeastMoves(Pegs({0, 0, 0, 0, 0}), 2), 31);
  EXPECT_EQ(LeastMoves(Pegs({2, 2, 2}), 2), 0);
  EXPECT_EQ(LeastMoves(Pegs({0, 2, 2}), 2), 1);
  EXPECT_EQ(LeastMoves(Pegs({1, 1, 0}), 2), 4);
}

TEST(HandTest, MovesAreThoseOfTheGame) {
  const Pegs pegs({0, 0, 2});
  const Gripper gripper({}, 3);
  EXPECT_THAT(LegalMoves(pegs, gripper),
              ElementsAre(HandMove{1, 1}, HandMove{1, 2}, HandMove{3, 1}));
}

TEST_F(HanoiWorldTest, FirstTick_SaysTaskPositionAndGripper) {
  EXPECT_THAT(Load({{"disks", "2"}}), IsEmpty());
  EXPECT_EQ(Sensed(kTask), "disks(2) peg(left) peg(middle) peg(right) target(right) ");
  EXPECT_EQ(Sensed(kCamera), "on_peg(1, left) on_peg(2, left) topmost(left, 1) ");
  EXPECT_EQ(Sensed(kGripper), "above(left) raised ");
}

TEST_F(HanoiWorldTest, DiskIsLiftedCarriedAndPutDown) {
  Load({{"disks", "2"}});
  Carry("left", "middle");
  EXPECT_EQ(world_.pegs(), Pegs({1, 0}));
  EXPECT_EQ(Sensed(kGripper), "above(middle) down ");
  Carry("left", "right");
  Carry("middle", "right");
  EXPECT_EQ(world_.outcome().state, sdk::Outcome::State::kReached);
  EXPECT_EQ(world_.outcome().message, "all disks are on the right peg");
  EXPECT_EQ(Measure("moves"), 3);
  EXPECT_EQ(Measure("least_moves"), 3);
  EXPECT_EQ(Measure("refusals"), 0);
}

TEST_F(HanoiWorldTest, MovementTakesItsTime) {
  Load({{"disks", "2"}, {"travel_speed", "0.5"}});
  Do("move_to", "right", 11);
  EXPECT_FALSE(world_.gripper().above().has_value());
  Do("move_to", "right");
  EXPECT_EQ(world_.gripper().above(), 2);
}

TEST_F(HanoiWorldTest, LargerDiskOnASmallerOne_Fails) {
  Load({{"disks", "2"}});
  Carry("left", "middle");
  Carry("left", "middle");
  EXPECT_EQ(world_.outcome().state, sdk::Outcome::State::kFailed);
  EXPECT_EQ(world_.outcome().message, "disk 2 was put on disk 1");
}

TEST_F(HanoiWorldTest, WhatCannotBeDoneIsNotDoneAndCounted) {
  Load({{"disks", "2"}});
  Do("lower", "", 10);
  const double x = world_.gripper().x();
  Do("move_to", "right", 5);
  EXPECT_EQ(world_.gripper().x(), x);
  EXPECT_EQ(Measure("refusals"), 1);
  Do("raise", "", 1);
  Do("grasp", "", 5);
  EXPECT_EQ(world_.gripper().held(), 0);
  EXPECT_EQ(Measure("refusals"), 2);
  Do("raise", "", 1);
  Do("release", "", 5);
  EXPECT_EQ(Measure("refusals"), 3);
}

TEST_F(HanoiWorldTest, GraspThatIsInterruptedBeginsAgain) {
  Load({{"disks", "2"}});
  Do("lower", "", 10);
  Do("grasp", "", 2);
  Do("lower", "", 1);
  Do("grasp", "", 2);
  EXPECT_EQ(world_.gripper().held(), 0);
  Do("grasp", "", 1);
  EXPECT_EQ(world_.gripper().held(), 1);
}

TEST_F(HanoiWorldTest, FingersSlipNowAndThen) {
  Load({{"disks", "1"}, {"slip", "0.9"}});
  Do("lower", "", 10);
  Do("grasp", "", 9);
  EXPECT_GT(Measure("slips"), 0);
}

TEST_F(HanoiWorldTest, HandKeepsToLegalPositions) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Load({{"disks", "4"}, {"start", "random"}, {"hand_every", "0.4"}, {"target", "left"}}, seed);
    Pegs before = world_.pegs();
    for (int i = 0; i < 100; ++i) {
      Do("raise");
      if (world_.pegs() == before) continue;
      int moved = 0;
      for (int disk = 1; disk <= 4; ++disk) {
        if (world_.pegs().peg_of(disk) == before.peg_of(disk)) continue;
        ++moved;
        EXPECT_EQ(before.Top(before.peg_of(disk)), disk);
        EXPECT_TRUE(before.Takes(world_.pegs().peg_of(disk), disk));
      }
      EXPECT_EQ(moved, 1);
      before = world_.pegs();
    }
    if (world_.outcome().state == sdk::Outcome::State::kRunning) {
      EXPECT_GE(Measure("hand_moves"), 15);
    }
  }
}

TEST_F(HanoiWorldTest, HandLeavesAPegToTheDiskInTheGripper) {
  Load({{"disks", "3"}, {"start", "rml"}});
  Do("lower", "", 20);
  Do("grasp", "", 3);
  Do("raise", "", 20);
  ASSERT_EQ(world_.gripper().held(), 3);
  EXPECT_THAT(LegalMoves(world_.pegs(), world_.gripper()),
              ElementsAre(HandMove{1, 0}, HandMove{1, 1}, HandMove{2, 0}));
}

TEST_F(HanoiWorldTest, EventMovesADiskOrSaysWhyNot) {
  Load({{"disks", "3"}});
  EXPECT_THAT(Event(1, "middle"), IsEmpty());
  EXPECT_EQ(world_.pegs(), Pegs({1, 0, 0}));
  EXPECT_EQ(Event(2, "middle").at(0).message, "the disk there is smaller");
  EXPECT_EQ(Event(3, "right").at(0).message, "a disk lies on disk 3");
  EXPECT_EQ(Event(1, "middle").at(0).message, "disk 1 is there already");
  EXPECT_EQ(Event(9, "middle").at(0).message, "there is no disk 4");
  EXPECT_EQ(Event(1, "top").at(0).message, "the pegs are left, middle and right");
}

TEST_F(HanoiWorldTest, StartPosition_IsAsGiven) {
  EXPECT_THAT(Load({{"disks", "3"}, {"start", "lmr"}}), IsEmpty());
  EXPECT_EQ(world_.pegs(), Pegs({0, 1, 2}));
  EXPECT_THAT(Load({{"disks", "3"}, {"start", "lm"}}).at(0).message, HasSubstr("3 letters"));
  EXPECT_THAT(Load({{"disks", "3"}, {"start", "lmx"}}).at(0).message, HasSubstr("l, m, r"));
}

TEST_F(HanoiWorldTest, DrawsAnAnimation) {
  const test::TemporaryFolder folder;
  Load({{"disks", "2"}});
  Carry("left", "middle");
  const auto written = world_.Draw(folder.path());
  ASSERT_THAT(written, ElementsAre(folder.path() / "hanoi.svg"));
  std::ifstream in(written[0]);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  EXPECT_THAT(text, HasSubstr("animateTransform"));
  EXPECT_THAT(world_.Draw(folder.path() / "none"), IsEmpty());
}

}  // namespace
}  // namespace latchwork::hanoi
