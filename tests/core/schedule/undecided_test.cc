// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/schedule/fakes.h"

namespace latchwork::schedule {
namespace {

using config::Transfer;
using logic::Fact;
using ::testing::ElementsAre;
using testing::FakeAgent;
using ::testing::IsEmpty;
using testing::kWorld;
using testing::Port;

std::string Text(const std::vector<Fact>& facts) {
  std::string text;
  for (const Fact& fact : facts) text += (text.empty() ? "" : " ") + logic::ToString(fact);
  return text;
}

/// Layer 1 leaves two goals undecided that exclude each other; layer 0 latches them and concludes
/// what the test makes of them.
class UndecidedTest : public ::testing::Test {
 protected:
  UndecidedTest() {
    fake.world->shape.inputs = {Port("drive", {{"slow", {}}, {"free", {}}})};
    fake.AddLayer({Port("pushes", {{"left", {}}, {"right", {}}})},
                  {Port("drive", {{"slow", {}}, {"free", {}}})});
    fake.AddLayer({}, {Port("pushes", {{"left", {}}, {"right", {}}})});
    fake.Wire({0, 0}, {kWorld, 0});
    fake.description(1).phase = 0;
    fake.reasoner(1).decide = [this](auto, const auto&, sdk::Decision& decision) {
      decision.status = sdk::Status::kUnknown;
      decision.undecided = {{0, fake.Fact("left"), {}}, {1, fake.Fact("right"), {}}};
      decision.states = {{0}, {1}};
    };
    fake.reasoner(0).decide = [this](std::span<const sdk::Latch> latches, const auto&,
                                     sdk::Decision& decision) {
      shown.push_back(Text(latches[0].facts));
      shown_undecided.push_back(Text(latches[0].undecided.facts));
      const bool pushed = !latches[0].facts.empty();
      fake.Conclude(decision, pushed ? 0 : 1, fake.Fact(pushed ? "slow" : "free"));
    };
  }

  /// What layer 0 is shown in the tick after layer 1 spoke, and what it then says.
  void Run(Transfer transfer) {
    fake.Wire({1, 0}, {0, 0}, std::nullopt, transfer);
    const auto lockstep = fake.Start();
    lockstep->Tick();
    shown.clear();
    shown_undecided.clear();
    lockstep->Tick();
    said = fake.world->told.back()[0];
  }

  FakeAgent fake;
  std::vector<std::string> shown;
  std::vector<std::string> shown_undecided;
  std::vector<std::string> said;
};

TEST_F(UndecidedTest, Single_NothingUndecidedIsHandedDown) {
  Run(Transfer::kSingle);
  EXPECT_THAT(shown, ElementsAre(""));
  EXPECT_THAT(said, ElementsAre("free"));
}

TEST_F(UndecidedTest, Open_EverySubsetIsLookedAtAndNothingThatRestsOnOneIsSaid) {
  Run(Transfer::kOpen);
  EXPECT_THAT(shown, ElementsAre("", "left", "right", "left right"));
  EXPECT_THAT(said, IsEmpty());
}

TEST_F(UndecidedTest, Refined_WhatHoldsInEachStateIsSaid) {
  Run(Transfer::kRefined);
  EXPECT_THAT(shown, ElementsAre("left", "right"));
  EXPECT_THAT(said, ElementsAre("slow"));
}

TEST_F(UndecidedTest, ReasonerThatTakesThem_GetsThemInItsLatch) {
  fake.reasoner(0).takes = true;
  Run(Transfer::kOpen);
  EXPECT_THAT(shown, ElementsAre(""));
  EXPECT_THAT(shown_undecided, ElementsAre("left right"));
}

TEST_F(UndecidedTest, FactThatContradictsTheBody_IsTakenOutOfTheStates) {
  fake.reasoner(0).admit = [](auto, std::size_t, std::span<const Fact> batch, auto& refused) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (logic::ToString(batch[i]) == "right") refused.push_back({i, "frozen"});
    }
  };
  Run(Transfer::kRefined);
  EXPECT_THAT(shown, ElementsAre("", "left"));
}

TEST_F(UndecidedTest, StatesThatContradictTheBody_LeaveTheLayerWithoutAnAnswer) {
  fake.reasoner(0).decide = [](std::span<const sdk::Latch> latches, const auto&,
                               sdk::Decision& decision) {
    decision.status =
        latches[0].facts.size() < 2 ? sdk::Status::kRefuted : sdk::Status::kInconsistent;
  };
  testing::Recorder recorder;
  fake.Wire({1, 0}, {0, 0});
  LockstepOptions options;
  options.observers = {&recorder};
  const auto lockstep = fake.Start(options);
  lockstep->Tick();
  lockstep->Tick();
  EXPECT_THAT(recorder.faults, IsEmpty());
  EXPECT_THAT(recorder.decided, ::testing::Contains("1 l0 unknown: []"));
}

TEST_F(UndecidedTest, MoreStatesThanCanBeLookedAt_AreUnknown) {
  fake.reasoner(1).decide = [this](auto, const auto&, sdk::Decision& decision) {
    decision.status = sdk::Status::kUnknown;
    for (std::int64_t i = 0; i < 7; ++i) {
      decision.undecided.push_back({0, fake.Fact("left"), {}});
    }
  };
  Run(Transfer::kOpen);
  EXPECT_THAT(shown, IsEmpty());
  EXPECT_THAT(said, IsEmpty());
}

TEST_F(UndecidedTest, ReasonerWithMemory_SeesDecidedFactsOnlyAndOnce) {
  fake.reasoner(0).remembers = true;
  Run(Transfer::kOpen);
  EXPECT_THAT(shown, ElementsAre(""));
}

TEST_F(UndecidedTest, BudgetThatRunsOutBetweenStates_IsUnknownAndNoFault) {
  testing::Recorder recorder;
  fake.reasoner(0).decide = [this](std::span<const sdk::Latch>, const sdk::Budget& budget,
                                   sdk::Decision& decision) {
    fake.Conclude(decision, 0, fake.Fact("slow"));
    decision.statistics.inferences = budget.inferences;
  };
  fake.Wire({1, 0}, {0, 0});
  LockstepOptions options;
  options.observers = {&recorder};
  const auto lockstep = fake.Start(options);
  lockstep->Tick();
  lockstep->Tick();
  EXPECT_THAT(recorder.faults, IsEmpty());
  EXPECT_EQ(fake.reasoner(0).decide_calls, 2U);
  EXPECT_THAT(recorder.decided, ::testing::Contains("1 l0 unknown: []"));
}

TEST_F(UndecidedTest, GoalThatAStateLeavesUndecided_StaysUndecidedInAnyState) {
  fake.reasoner(0).decide = [this](std::span<const sdk::Latch> latches, const auto&,
                                   sdk::Decision& decision) {
    decision.status = sdk::Status::kUnknown;
    if (latches[0].facts.size() == 1) {
      fake.Conclude(decision, 0, fake.Fact("slow"));
    } else {
      decision.undecided = {{1, fake.Fact("free"), {}}};
    }
  };
  struct Watch : RunObserver {
    bool OnTick(const TickRecord& record) override {
      if (record.tick == 1) decision = *record.decisions[0].decision;
      return true;
    }
    sdk::Decision decision;
  } watch;
  fake.Wire({1, 0}, {0, 0});
  LockstepOptions options;
  options.observers = {&watch};
  const auto lockstep = fake.Start(options);
  lockstep->Tick();
  lockstep->Tick();
  EXPECT_EQ(watch.decision.undecided.size(), 2U);
  EXPECT_THAT(watch.decision.states, IsEmpty());
}

TEST_F(UndecidedTest, StateOfAnUnknownGoal_IsAFault) {
  testing::Recorder recorder;
  fake.reasoner(1).decide = [](auto, const auto&, sdk::Decision& decision) {
    decision.status = sdk::Status::kUnknown;
    decision.states = {{0}};
  };
  fake.Wire({1, 0}, {0, 0});
  LockstepOptions options;
  options.observers = {&recorder};
  fake.Start(options)->Tick();
  ASSERT_EQ(recorder.faults.size(), 1U);
  EXPECT_EQ(recorder.faults[0].kind, FaultKind::kBadConclusion);
}

}  // namespace
}  // namespace latchwork::schedule
