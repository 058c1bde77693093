// SPDX-License-Identifier: BSD-3-Clause
// Whatever a part does wrong is contained, recorded and answered with the layer's fallback.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/core/schedule/fakes.h"

namespace latchwork::schedule::testing {
namespace {

using logic::Term;
using sdk::ArgumentType;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class FaultTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fake.world->shape.outputs = {Port("now", {{"now", {ArgumentType::kInteger}}})};
    fake.world->shape.inputs = {Port("drive", {{"go", {ArgumentType::kReal}}, {"halt", {}}})};
    fake.world->observe = [this](std::uint64_t tick, std::span<sdk::Batch> sensors) {
      sensors[0].updated = tick == 0;
      sensors[0].facts = {fake.Fact("now", {Term::Integer(0)})};
    };
    fake.AddLayer({Port("sense", {{"now", {ArgumentType::kInteger}}})},
                  {Port("motion", {{"go", {ArgumentType::kReal}}, {"halt", {}}})});
    fake.layer(0).fallback = {{0, {fake.Fact("halt")}}};
    fake.Wire({kWorld, 0}, {0, 0});
    fake.Wire({0, 0}, {kWorld, 0});
    fake.agent.max_ticks = 1;
  }

  using Decider = FakeReasoner::Decider;

  /// The kind of the only fault of a run in which the layer decides like this.
  FaultKind Provoke(Decider decide) {
    fake.reasoner(0).decide = std::move(decide);
    result = fake.Start({.observers = {&recorder}})->Run();
    EXPECT_EQ(recorder.faults.size(), 1U);
    return recorder.faults.empty() ? FaultKind::kFailed : recorder.faults.front().kind;
  }
  FaultKind ProvokeWith(std::size_t goal, logic::Fact fact) {
    return Provoke([this, goal, fact](auto, auto&, sdk::Decision& decision) {
      fake.Conclude(decision, goal, fact);
    });
  }
  void ExpectFallback(std::string_view message) {
    ASSERT_EQ(recorder.faults.size(), 1U);
    EXPECT_THAT(recorder.faults[0].message, HasSubstr(std::string(message)));
    EXPECT_EQ(recorder.faults[0].layer, 0U);
    EXPECT_EQ(recorder.faults[0].tick, 0U);
    EXPECT_EQ(recorder.faults[0].plugin, "reasoner0");
    EXPECT_THAT(fake.world->told.at(0).at(0), ElementsAre("halt"));
    EXPECT_EQ(result.layers.at(0).faults, 1U);
  }

  FakeAgent fake;
  Recorder recorder;
  RunResult result;
};

TEST_F(FaultTest, Exception) {
  EXPECT_EQ(Provoke([](auto, auto&, auto&) { throw std::runtime_error("boom"); }),
            FaultKind::kException);
  ExpectFallback("boom");
}

TEST_F(FaultTest, ExceptionOfAnyType) {
  EXPECT_EQ(Provoke([](auto, auto&, auto&) { throw 7; }), FaultKind::kException);
  ExpectFallback("not a std::exception");
}

TEST_F(FaultTest, ExceptionAfterSomeConclusionsSaysNoneOfThem) {
  EXPECT_EQ(Provoke([this](auto, auto&, sdk::Decision& decision) {
              fake.Conclude(decision, 0, fake.Fact("go", {Term::Real(1)}));
              throw std::runtime_error("boom");
            }),
            FaultKind::kException);
  ExpectFallback("boom");
}

TEST_F(FaultTest, NotANumber) {
  EXPECT_EQ(ProvokeWith(0, fake.Fact("go", {Term::Real(std::nan(""))})), FaultKind::kBadConclusion);
  ExpectFallback("argument 1 of go/1 must be a finite number");
}

TEST_F(FaultTest, Infinity) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ProvokeWith(0, fake.Fact("go", {Term::Real(infinity)})), FaultKind::kBadConclusion);
  ExpectFallback("must be a finite number");
}

TEST_F(FaultTest, WrongType) {
  EXPECT_EQ(ProvokeWith(0, fake.Fact("go", {fake.Name("fast")})), FaultKind::kBadConclusion);
  ExpectFallback("must be a finite number");
}

TEST_F(FaultTest, ConclusionThatIsNotGround) {
  EXPECT_EQ(ProvokeWith(0, fake.Fact("go", {Term::Var(0)})), FaultKind::kBadConclusion);
  ExpectFallback("must be a finite number");
}

TEST_F(FaultTest, UndeclaredPredicate) {
  EXPECT_EQ(ProvokeWith(0, fake.Fact("fly")), FaultKind::kBadConclusion);
  ExpectFallback("port motion does not declare fly/0");
}

TEST_F(FaultTest, UnknownGoal) {
  EXPECT_EQ(ProvokeWith(9, fake.Fact("halt")), FaultKind::kBadConclusion);
  ExpectFallback("goal 9");
}

TEST_F(FaultTest, ConclusionOnAnUnlistedAssumption) {
  EXPECT_EQ(Provoke([this](auto, auto&, sdk::Decision& decision) {
              fake.Conclude(decision, 1, fake.Fact("halt"));
              decision.conclusions.back().assumptions = {3};
            }),
            FaultKind::kBadConclusion);
  ExpectFallback("assumption");
}

TEST_F(FaultTest, OverBudget) {
  EXPECT_EQ(Provoke([](auto, const sdk::Budget& budget, sdk::Decision& decision) {
              decision.statistics.inferences = budget.inferences + 1;
            }),
            FaultKind::kOverBudget);
  ExpectFallback("1001 inferences were spent, 1000 allowed");
}

TEST_F(FaultTest, Inconsistent) {
  EXPECT_EQ(Provoke([](auto, auto&, sdk::Decision& decision) {
              decision.status = sdk::Status::kInconsistent;
              decision.message = "p and not p";
            }),
            FaultKind::kInconsistent);
  ExpectFallback("p and not p");
}

TEST_F(FaultTest, Failed) {
  EXPECT_EQ(Provoke([](auto, auto&, sdk::Decision& decision) {
              decision.status = sdk::Status::kFailed;
              decision.message = "out of order";
            }),
            FaultKind::kFailed);
  ExpectFallback("out of order");
}

TEST_F(FaultTest, TimeoutIsCancelledByTheWatchdog) {
  fake.reasoner(0).decide = [](auto, const sdk::Budget& budget, sdk::Decision&) {
    while (!budget.cancelled->load()) std::this_thread::yield();
  };
  result =
      fake.Start({.wall_limit = std::chrono::milliseconds(1), .observers = {&recorder}})->Run();
  ASSERT_EQ(recorder.faults.size(), 1U);
  EXPECT_EQ(recorder.faults[0].kind, FaultKind::kTimeout);
  ExpectFallback("cancelled");
}

TEST_F(FaultTest, ReasonerThatIgnoresItsCancellationIsReportedOnce) {
  std::atomic<int> reports = 0;
  fake.reasoner(0).decide = [&](auto, auto&, auto&) {
    while (reports == 0) std::this_thread::yield();
  };
  std::string named;
  std::uint64_t tick = 99;
  LockstepOptions options{.wall_limit = std::chrono::milliseconds(1),
                          .grace = std::chrono::milliseconds(1)};
  options.on_hang = [&](std::string_view plugin, std::uint64_t at) {
    named = plugin;
    tick = at;
    ++reports;
  };
  fake.Start(std::move(options))->Run();
  EXPECT_EQ(reports, 1);
  EXPECT_EQ(named, "reasoner0 (layer l0)");
  EXPECT_EQ(tick, 0U);
}

TEST_F(FaultTest, ReasonerThatNeverReturnsEndsTheProcess) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  fake.reasoner(0).decide = [](auto, auto&, auto&) {
    for (;;) std::this_thread::yield();
  };
  EXPECT_EXIT(fake.Start({.wall_limit = std::chrono::milliseconds(1),
                          .grace = std::chrono::milliseconds(1)})
                  ->Run(),
              ::testing::ExitedWithCode(5),
              "plugin reasoner0 .layer l0. does not return from tick 0");
}

TEST_F(FaultTest, AdmissionThatThrows) {
  fake.reasoner(0).admit = [](auto, std::size_t, auto, auto&) { throw std::runtime_error("boom"); };
  fake.agent.max_ticks = 2;
  result = fake.Start({.observers = {&recorder}})->Run();
  ASSERT_EQ(recorder.faults.size(), 2U);
  EXPECT_EQ(recorder.faults[0].kind, FaultKind::kAdmission);
  EXPECT_EQ(recorder.faults[0].message, "boom");
  EXPECT_THAT(fake.world->told.at(0).at(0), ElementsAre("halt"));
  EXPECT_THAT(fake.world->told.at(1).at(0), ElementsAre("halt"));
  EXPECT_EQ(fake.reasoner(0).decide_calls, 0U);
  EXPECT_EQ(result.layers[0].refused, 1U);
}

TEST_F(FaultTest, FallbackOfTheAgentFileReplacesTheLayersOwn) {
  fake.description(0).fallback = {{{0, fake.Fact("go", {Term::Integer(0)})}}};
  EXPECT_EQ(Provoke([](auto, auto&, auto&) { throw std::runtime_error("boom"); }),
            FaultKind::kException);
  EXPECT_THAT(fake.world->told.at(0).at(0), ElementsAre("go(0)"));
}

TEST_F(FaultTest, LayerWithoutFallbackFallsSilent) {
  fake.layer(0).fallback.clear();
  EXPECT_EQ(Provoke([](auto, auto&, auto&) { throw std::runtime_error("boom"); }),
            FaultKind::kException);
  EXPECT_THAT(fake.world->told.at(0).at(0), IsEmpty());
}

TEST_F(FaultTest, LayerGoesOnAfterAFault) {
  fake.agent.max_ticks = 3;
  EXPECT_EQ(Provoke([this](auto, auto&, sdk::Decision& decision) {
              if (fake.reasoner(0).decide_calls == 2) throw std::runtime_error("boom");
              fake.Conclude(decision, 0, fake.Fact("go", {Term::Integer(1)}));
            }),
            FaultKind::kException);
  EXPECT_THAT(fake.world->told.at(0).at(0), ElementsAre("go(1)"));
  EXPECT_THAT(fake.world->told.at(1).at(0), ElementsAre("halt"));
  EXPECT_THAT(fake.world->told.at(2).at(0), ElementsAre("go(1)"));
  EXPECT_EQ(recorder.faults[0].tick, 1U);
}

TEST_F(FaultTest, WorldThatThrowsEndsTheRun) {
  fake.agent.max_ticks = 5;
  fake.world->step = [](std::uint64_t tick) {
    if (tick == 2) throw std::runtime_error("earthquake");
  };
  result = fake.Start({.observers = {&recorder}})->Run();
  EXPECT_EQ(result.state, RunResult::State::kFailed);
  EXPECT_EQ(result.message, "world world: earthquake");
  EXPECT_EQ(result.ticks, 3U);
  ASSERT_EQ(recorder.faults.size(), 1U);
  EXPECT_EQ(recorder.faults[0].layer, Fault::kWorld);
  EXPECT_EQ(recorder.faults[0].tick, 2U);
}

TEST_F(FaultTest, WorldThatThrowsWhileItIsObservedDecidesNothing) {
  fake.world->observe = [](std::uint64_t, auto) { throw std::runtime_error("fog"); };
  result = fake.Start()->Run();
  EXPECT_EQ(result.state, RunResult::State::kFailed);
  EXPECT_EQ(fake.reasoner(0).decide_calls, 0U);
  EXPECT_THAT(fake.world->told, IsEmpty());
}

TEST_F(FaultTest, EveryKindHasAName) {
  for (const FaultKind kind : {FaultKind::kException, FaultKind::kTimeout, FaultKind::kOverBudget,
                               FaultKind::kInconsistent, FaultKind::kFailed,
                               FaultKind::kBadConclusion, FaultKind::kAdmission}) {
    EXPECT_FALSE(schedule::Name(kind).empty());
  }
}

}  // namespace
}  // namespace latchwork::schedule::testing
