// SPDX-License-Identifier: BSD-3-Clause
// What happens in a tick, in which order, and when it is visible.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/schedule/fakes.h"

namespace latchwork::schedule::testing {
namespace {

using logic::Term;
using sdk::ArgumentType;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// World sensor `now` says now(K) in each tick; layer 0 passes on as go(K), which drives `drive`.
class TickOrderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fake.world->shape.outputs = {Port("now", {{"now", {ArgumentType::kInteger}}})};
    fake.world->shape.inputs = {Port("drive", {{"go", {ArgumentType::kInteger}}})};
    fake.world->observe = [this](std::uint64_t tick, std::span<sdk::Batch> sensors) {
      sensors[0].updated = true;
      sensors[0].facts = {fake.Fact("now", {Term::Integer(static_cast<std::int64_t>(tick))})};
    };
    low = AddCopier();
    fake.Wire({kWorld, 0}, {low, 0});
    fake.Wire({low, 0}, {kWorld, 0});
    fake.agent.max_ticks = 6;
  }

  /// Says go(K) for every now(K) of its sensor latch and every go(K) of its input latch.
  std::size_t AddCopier() {
    const std::size_t layer = fake.AddLayer({Port("sense", {{"now", {ArgumentType::kInteger}}}),
                                             Port("above", {{"go", {ArgumentType::kInteger}}})},
                                            {Port("out", {{"go", {ArgumentType::kInteger}}})});
    fake.reasoner(layer).decide = [this](std::span<const sdk::Latch> latches, const sdk::Budget&,
                                         sdk::Decision& decision) {
      for (const sdk::Latch& latch : latches) {
        for (const logic::Fact& fact : latch.facts) {
          fake.Conclude(decision, 0, fake.Fact("go", {fact.argument(0)}));
        }
      }
    };
    return layer;
  }

  /// What effector 0 was told in each tick.
  std::vector<std::string> Run() {
    fake.Start({.observers = {&recorder}})->Run();
    std::vector<std::string> told;
    for (const auto& tick : fake.world->told) {
      std::string line;
      for (const std::string& fact : tick[0]) line += (line.empty() ? "" : " ") + fact;
      told.push_back(line);
    }
    return told;
  }

  FakeAgent fake;
  Recorder recorder;
  std::size_t low = 0;
};

TEST_F(TickOrderTest, WorldIsAskedInOrder) {
  fake.agent.max_ticks = 2;
  fake.agent.events = {{1, fake.Fact("shut"), {}}, {1, fake.Fact("impossible"), {}}};
  Run();
  EXPECT_THAT(fake.world->calls,
              ElementsAre("observe 0", "apply 0", "step 0", "event 1 shut", "event 1 impossible",
                          "observe 1", "apply 1", "step 1"));
  EXPECT_THAT(recorder.events, ElementsAre("1 shut ", "1 impossible no such door"));
}

TEST_F(TickOrderTest, SensorReachesEffectorInTheSameTick) {
  EXPECT_THAT(Run(), ElementsAre("go(0)", "go(1)", "go(2)", "go(3)", "go(4)", "go(5)"));
}

TEST_F(TickOrderTest, PeriodAndPhaseSayWhenALayerIsDueAndTheEffectorHoldsInBetween) {
  fake.description(low).period = 2;
  fake.description(low).phase = 1;
  EXPECT_THAT(Run(), ElementsAre("", "go(1)", "go(1)", "go(3)", "go(3)", "go(5)"));
  EXPECT_EQ(fake.reasoner(low).decide_calls, 3U);
}

TEST_F(TickOrderTest, EffectorIsUpdatedInTheTicksInWhichItIsTold) {
  fake.description(low).period = 2;
  fake.description(low).phase = 1;
  Run();
  EXPECT_THAT(fake.world->updated,
              ElementsAre(ElementsAre(false), ElementsAre(true), ElementsAre(false),
                          ElementsAre(true), ElementsAre(false), ElementsAre(true)));
}

TEST_F(TickOrderTest, EffectorIsToldNothingOnceTheWireIsStale) {
  fake.description(low).period = 4;
  fake.agent.wires[1].stale_after = 2;
  EXPECT_THAT(Run(), ElementsAre("go(0)", "go(0)", "", "", "go(4)", "go(4)"));
}

TEST_F(TickOrderTest, LatencyDelaysTheEffector) {
  fake.description(low).latency = 2;
  EXPECT_THAT(Run(), ElementsAre("", "", "go(0)", "go(1)", "go(2)", "go(3)"));
}

TEST_F(TickOrderTest, LongLatencyAndPeriodKeepTheOrder) {
  fake.description(low).period = 2;
  fake.description(low).latency = 3;
  EXPECT_THAT(Run(), ElementsAre("", "", "", "go(0)", "go(0)", "go(2)"));
}

TEST_F(TickOrderTest, ConclusionsReachALowerLayerOneTickLater) {
  fake.agent.wires.clear();
  const std::size_t high = AddCopier();
  fake.Wire({kWorld, 0}, {high, 0});
  fake.Wire({high, 0}, {low, 1});
  fake.Wire({low, 0}, {kWorld, 0});
  EXPECT_THAT(Run(), ElementsAre("", "go(0)", "go(1)", "go(2)", "go(3)", "go(4)"));
}

TEST_F(TickOrderTest, ConclusionsReachALowerLayerOneTickAndTheLatencyLater) {
  fake.agent.wires.clear();
  const std::size_t high = AddCopier();
  fake.description(high).latency = 2;
  fake.Wire({kWorld, 0}, {high, 0});
  fake.Wire({high, 0}, {low, 1});
  fake.Wire({low, 0}, {kWorld, 0});
  EXPECT_THAT(Run(), ElementsAre("", "", "", "go(0)", "go(1)", "go(2)"));
}

TEST_F(TickOrderTest, UnknownDeliversWhatWasProved) {
  fake.reasoner(low).decide = [this](auto, const sdk::Budget&, sdk::Decision& decision) {
    fake.Conclude(decision, 0, fake.Fact("go", {Term::Integer(7)}));
    decision.status = sdk::Status::kUnknown;
    decision.limit = sdk::Limit::kInferences;
  };
  fake.agent.max_ticks = 1;
  EXPECT_THAT(Run(), ElementsAre("go(7)"));
  EXPECT_THAT(recorder.faults, IsEmpty());
}

TEST_F(TickOrderTest, EffectorRefusesWhatItsContractForbids) {
  fake.world->shape.inputs = {Port("drive", {{"go", {ArgumentType::kSymbol}}})};
  fake.agent.max_ticks = 1;
  EXPECT_THAT(Run(), ElementsAre(""));
  EXPECT_THAT(recorder.refused, ElementsAre("0 world.0 go(0): argument 1 of go/1 must be a name"));
}

TEST_F(TickOrderTest, RunEndsWhenTheWorldIsReached) {
  fake.world->say_outcome = [this] {
    const bool there = fake.world->calls.back() == "step 2";
    return sdk::Outcome{there ? sdk::Outcome::State::kReached : sdk::Outcome::State::kRunning,
                        there ? "at home" : ""};
  };
  const auto run = fake.Start({.observers = {&recorder}});
  const RunResult result = run->Run();
  EXPECT_EQ(result.state, RunResult::State::kReached);
  EXPECT_EQ(result.message, "at home");
  EXPECT_EQ(result.ticks, 3U);
  EXPECT_EQ(recorder.ended, 3U);
  EXPECT_FALSE(run->Tick());
}

TEST_F(TickOrderTest, RunEndsWhenTheWorldHasFailed) {
  fake.world->say_outcome = [] { return sdk::Outcome{sdk::Outcome::State::kFailed, "collision"}; };
  const RunResult result = fake.Start()->Run();
  EXPECT_EQ(result.state, RunResult::State::kFailed);
  EXPECT_EQ(result.message, "collision");
  EXPECT_EQ(result.ticks, 1U);
}

TEST_F(TickOrderTest, RunEndsWhenTheTicksAreUsedUp) {
  const RunResult result = fake.Start({.max_ticks = 4})->Run();
  EXPECT_EQ(result.state, RunResult::State::kNotReached);
  EXPECT_EQ(result.ticks, 4U);
}

TEST_F(TickOrderTest, RunOfNoTicksDoesNothing) {
  const RunResult result = fake.Start({.max_ticks = 0})->Run();
  EXPECT_EQ(result.ticks, 0U);
  EXPECT_THAT(fake.world->calls, IsEmpty());
}

TEST_F(TickOrderTest, ObserverEndsTheRun) {
  recorder.stop_at = 1;
  const RunResult result = fake.Start({.observers = {&recorder}})->Run();
  EXPECT_EQ(result.state, RunResult::State::kStopped);
  EXPECT_EQ(result.ticks, 2U);
}

}  // namespace
}  // namespace latchwork::schedule::testing
