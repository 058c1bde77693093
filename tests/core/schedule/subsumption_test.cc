// SPDX-License-Identifier: BSD-3-Clause
// Higher layers subsume and inhibit lower ones; defaults are retracted and restored.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/schedule/fakes.h"

namespace latchwork::schedule::testing {
namespace {

using sdk::ArgumentType;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Layer 1 pushes with object(o) while `speaks`; layer 0 goes where it is pushed, else ahead, and
/// assumes that there is no object unless its latch says so.
class SubsumptionTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fake.world->shape.inputs = {Port("drive", {{"ahead", {}}, {"pushed", {}}})};
    fake.AddLayer({Port("objects", {{"object", {ArgumentType::kSymbol}}})},
                  {Port("motion", {{"ahead", {}}, {"pushed", {}}})});
    fake.AddLayer({}, {Port("push", {{"object", {ArgumentType::kSymbol}}})});
    fake.Wire({0, 0}, {kWorld, 0});
    fake.reasoner(0).decide = [this](std::span<const sdk::Latch> latches, auto&,
                                     sdk::Decision& decision) {
      const bool pushed = !latches[0].facts.empty();
      decision.assumptions.push_back(
          {fake.Fact("object", {fake.Name("o")}),
           pushed ? sdk::Assumption::State::kRetracted : sdk::Assumption::State::kMade});
      fake.Conclude(decision, pushed ? 1 : 0, fake.Fact(pushed ? "pushed" : "ahead"));
    };
    fake.reasoner(1).decide = [this](auto, auto&, sdk::Decision& decision) {
      if (speaks(fake.reasoner(1).decide_calls - 1)) {
        fake.Conclude(decision, 0, fake.Fact("object", {fake.Name("o")}));
      }
    };
  }

  std::vector<std::string> Run() {
    result = fake.Start({.observers = {&recorder}})->Run();
    std::vector<std::string> told;
    for (const auto& tick : fake.world->told) told.push_back(tick[0].empty() ? "" : tick[0][0]);
    return told;
  }

  FakeAgent fake;
  Recorder recorder;
  RunResult result;
  std::function<bool(std::size_t decision)> speaks = [](std::size_t) { return true; };
};

TEST_F(SubsumptionTest, DefaultIsRetractedWhileTheHigherLayerSpeaksAndRestoredAfter) {
  fake.Wire({1, 0}, {0, 0});
  fake.agent.max_ticks = 5;
  speaks = [](std::size_t decision) { return decision == 1 || decision == 2; };
  EXPECT_THAT(Run(), ElementsAre("ahead", "ahead", "pushed", "pushed", "ahead"));
  EXPECT_EQ(result.layers[0].retracted, 1U);
}

TEST_F(SubsumptionTest, LowerLayerFallsBackWithinStaleAfterAndReturns) {
  fake.Wire({1, 0}, {0, 0}, 2);
  fake.description(1).period = 5;
  fake.agent.max_ticks = 8;
  EXPECT_THAT(Run(), ElementsAre("ahead", "pushed", "pushed", "ahead", "ahead", "ahead", "pushed",
                                 "pushed"));
  EXPECT_THAT(recorder.latched,
              ElementsAre("1 l0.0@1: object(o)", "3 l0.0@2!: ", "6 l0.0@3: object(o)"));
}

TEST_F(SubsumptionTest, RefusalIsRecordedAndCounted) {
  fake.Wire({1, 0}, {0, 0});
  fake.agent.max_ticks = 3;
  fake.reasoner(0).admit = [](auto, std::size_t, auto, std::vector<sdk::Refusal>& refused) {
    refused.push_back({0, "axiom no_objects"});
  };
  EXPECT_THAT(Run(), ElementsAre("ahead", "ahead", "ahead"));
  EXPECT_THAT(recorder.refused, ElementsAre("1 l0.0 object(o): axiom no_objects"));
  EXPECT_EQ(result.layers[0].refused, 1U);
}

TEST_F(SubsumptionTest, InhibitedOutputIsSilentWhileTheInhibitorHoldsFacts) {
  fake.agent.inhibitions = {{{1, 0}, {0, 0}, 1, {}}};
  fake.agent.max_ticks = 4;
  speaks = [](std::size_t decision) { return decision == 1 || decision == 2; };
  EXPECT_THAT(Run(), ElementsAre("ahead", "", "", "ahead"));
  EXPECT_THAT(recorder.inhibited, ElementsAre("1 l0.0", "2 l0.0"));
}

TEST_F(SubsumptionTest, InhibitionHoldsForItsTicks) {
  fake.agent.inhibitions = {{{1, 0}, {0, 0}, 2, {}}};
  fake.description(1).period = 4;
  fake.agent.max_ticks = 5;
  EXPECT_THAT(Run(), ElementsAre("", "", "ahead", "ahead", ""));
}

TEST_F(SubsumptionTest, InhibitionTakesACommandAwayFromTheEffector) {
  fake.agent.inhibitions = {{{1, 0}, {0, 0}, 1, {}}};
  fake.description(0).period = 3;
  fake.description(1).period = 9;
  fake.description(1).phase = 1;
  fake.agent.max_ticks = 4;
  EXPECT_THAT(Run(), ElementsAre("ahead", "", "", "ahead"));
  EXPECT_THAT(recorder.inhibited, IsEmpty()) << "no batch was kept from leaving";
}

TEST_F(SubsumptionTest, InhibitedBatchDoesNotReachALatch) {
  fake.AddLayer({}, {Port("hush", {{"hush", {}}})});
  fake.reasoner(2).decide = [this](auto, auto&, sdk::Decision& decision) {
    fake.Conclude(decision, 0, fake.Fact("hush"));
  };
  fake.Wire({1, 0}, {0, 0});
  fake.agent.inhibitions = {{{2, 0}, {1, 0}, 1, {}}};
  fake.agent.max_ticks = 3;
  EXPECT_THAT(Run(), ElementsAre("ahead", "ahead", "ahead"));
}

TEST_F(SubsumptionTest, SensorInhibits) {
  fake.world->shape.outputs = {Port("alarm", {{"alarm", {}}})};
  fake.world->observe = [this](std::uint64_t tick, std::span<sdk::Batch> sensors) {
    sensors[0].updated = true;
    sensors[0].facts.clear();
    if (tick == 1) sensors[0].facts.push_back(fake.Fact("alarm"));
  };
  fake.agent.inhibitions = {{{kWorld, 0}, {0, 0}, 1, {}}};
  fake.agent.max_ticks = 3;
  EXPECT_THAT(Run(), ElementsAre("ahead", "", "ahead"));
}

TEST_F(SubsumptionTest, NothingInhibitsAReflex) {
  fake.layer(0).shape.outputs[0].uninhibitable = true;
  fake.agent.inhibitions = {{{1, 0}, {0, 0}, 1, {}}};
  fake.agent.max_ticks = 2;
  EXPECT_THAT(Run(), ElementsAre("ahead", "ahead"));
}

}  // namespace
}  // namespace latchwork::schedule::testing
