// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "tests/reasoners/icarus/program_mind.h"

namespace latchwork::icarus::testing {
namespace {

using sdk::ArgumentType;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr ArgumentType kInteger = ArgumentType::kInteger;
constexpr ArgumentType kReal = ArgumentType::kReal;
constexpr ArgumentType kSymbol = ArgumentType::kSymbol;
constexpr ArgumentType kAny = ArgumentType::kAny;

/// Follows whoever is seen, nearest or not.
constexpr std::string_view kFollow = R"((top (Follow))
(Follow () :requires ((seen ?who ?where)) :means ((GoTo ?where)))
(GoTo (?where) :action ({go ?where})))";

void AddFollow(ProgramMind& mind) {
  mind.Input("seen", {kSymbol, kAny});
  mind.Output("go", {kAny});
}

TEST(IcarusReasonerTest, ConcludesActsFromLatches) {
  ProgramMind mind(kFollow);
  AddFollow(mind);
  mind.Load();
  EXPECT_THAT(mind.Decide(), IsEmpty());
  EXPECT_EQ(mind.decision.status, sdk::Status::kRefuted);
  mind.Latch(0, {"seen('Anna', at('Room', 3))"});
  EXPECT_THAT(mind.Decide(), ElementsAre("go(at('Room', 3))"));
  EXPECT_EQ(mind.decision.status, sdk::Status::kProved);
  EXPECT_EQ(mind.decision.statistics.depth, 2U);
  EXPECT_GT(mind.decision.statistics.inferences, 0U);
  mind.Latch(0, {});
  EXPECT_THAT(mind.Decide(), IsEmpty());
}

TEST(IcarusReasonerTest, EachConclusionOnceByGoal) {
  ProgramMind mind(R"((top (Top))
(Top () :requires ((seen ?who)) :means ((Both ?who)))
(Both (?who) :action ({wave} {go ?who} {go ?who})))");
  mind.Input("seen", {kSymbol});
  mind.Output("go", {kSymbol});
  mind.Output("wave", {});
  mind.Parameter("acts", "all");
  mind.Load();
  mind.Latch(0, {"seen(a)", "seen(b)", "seen(a)"});
  EXPECT_THAT(mind.Decide(), ElementsAre("go(a)", "go(b)", "wave"));
  EXPECT_EQ(mind.decision.conclusions[2].goal, 1U);
}

TEST(IcarusReasonerTest, ParametersAndInitialFactsAreInMemory) {
  ProgramMind mind(R"((top (Top))
(facts (mine 1) (mine 2))
(Top () :requires ((mine ?m) (limit ?l) {> ?m ?l}) :means ((Go ?m)))
(Go (?m) :action ({go ?m})))");
  mind.Output("go", {kInteger});
  mind.facts = {mind.Fact("limit(1.5)")};
  mind.Load();
  EXPECT_THAT(mind.Decide(), ElementsAre("go(2)"));
}

TEST(IcarusReasonerTest, LatchesKeepTheOrderOfTheirBatches) {
  ProgramMind mind(kFollow);
  AddFollow(mind);
  mind.Input("other", {});
  mind.Parameter("acts", "all");
  mind.Load();
  const std::vector<std::vector<std::string>> batches = {
      {"seen(a, 1)", "seen(b, 2)", "seen(c, 3)"},
      {"seen(a, 1)", "seen(b, 9)", "seen(c, 3)"},
      {"seen(c, 3)", "seen(a, 1)", "seen(b, 9)"},
      {"seen(d, 4)", "seen(c, 3)", "seen(a, 1)", "seen(b, 9)"},
      {"seen(b, 9)", "seen(a, 1)"},
      {"seen(e, 5)"}};
  for (const auto& batch : batches) {
    mind.Latch(0, batch);
    std::vector<std::string> wanted;
    for (const std::string& fact : batch) wanted.push_back("go(" + fact.substr(8, 1) + ")");
    EXPECT_EQ(mind.Decide(), wanted);
    EXPECT_EQ(mind.Decide(), wanted) << "unchanged";
  }
}

TEST(IcarusReasonerTest, WhatTheProgramStoresStaysAndWhatItForgetsReturns) {
  ProgramMind mind(R"((top (Top))
(Top () :requires ((*not* (Count)) (*not* (Swallow))) :means ((Never)))
(Count () :requires ((seen ?x) (Keep ?x) (kept ?y)) :means ((Say ?y)))
(Keep (?x) :sensor ({store (kept ?x)}))
(Swallow () :requires ((seen ?x) (Drop ?x)) :means ((Never)))
(Drop (?x) :sensor ({forget (seen ?x)}))
(Never () :objective ((kept nothing)))
(Say (?y) :action ({say ?y})))");
  mind.Input("seen", {kSymbol});
  mind.Output("say", {kSymbol});
  mind.Parameter("acts", "all");
  mind.Load();
  mind.Latch(0, {"seen(a)"});
  EXPECT_THAT(mind.Decide(), ElementsAre("say(a)"));
  EXPECT_THAT(mind.Decide(), ElementsAre("say(a)")) << "forgotten within a cycle only";
  mind.Latch(0, {"seen(b)"});
  EXPECT_THAT(mind.Decide(), ElementsAre("say(a)", "say(b)"));
  mind.Latch(0, {});
  EXPECT_THAT(mind.Decide(), IsEmpty());
}

TEST(IcarusReasonerTest, ActsChangeMemoryWhenIssued) {
  ProgramMind mind(R"((top (Top))
(facts (step 1))
(Top () :requires ((step ?n) (bind ?m {+ ?n 1})) :means ((Go ?n ?m)))
(Go (?n ?m) :action ({go ?n} {update (step ?n) (step ?m)})))");
  mind.Output("go", {kInteger});
  mind.Load();
  EXPECT_THAT(mind.Decide(), ElementsAre("go(1)"));
  EXPECT_THAT(mind.Decide(), ElementsAre("go(2)"));
}

/// A recursion whose depth is that of the number it is given.
constexpr std::string_view kDeep = R"((top (Deep 9))
(Deep (?n) :objective ({= ?n 0}) :requires ((bind ?m {- ?n 1})) :means ((Deep ?m) (Wave)))
(Wave () :action ({wave})))";

TEST(IcarusReasonerTest, LimitsMakeTheDecisionUnknown) {
  ProgramMind mind(kDeep);
  mind.Output("wave", {});
  mind.Parameter("acts", "all");
  mind.Load();
  mind.Decide();
  EXPECT_EQ(mind.decision.status, sdk::Status::kProved);
  mind.budget.depth = 5;
  EXPECT_THAT(mind.Decide(), ElementsAre("wave"));
  EXPECT_EQ(mind.decision.status, sdk::Status::kUnknown);
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kDepth);
  mind.budget.depth = 64;
  mind.budget.inferences = 7;
  mind.Decide();
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kInferences);
  EXPECT_EQ(mind.decision.statistics.inferences, 7U);
}

TEST(IcarusReasonerTest, CancelledAndLateCyclesEnd) {
  ProgramMind mind(kDeep);
  mind.Output("wave", {});
  mind.Load();
  const std::atomic<bool> cancelled = true;
  mind.budget.cancelled = &cancelled;
  mind.Decide();
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kCancelled);
  mind.budget.cancelled = nullptr;
  mind.budget.deadline = std::chrono::steady_clock::time_point();
  mind.Decide();
  EXPECT_EQ(mind.decision.status, sdk::Status::kUnknown);
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kTime);
}

/// Faults while a sensor is silent, and waves all the same.
constexpr std::string_view kFaulty = R"((top (Top))
(Top () :requires ((*not* (Inner))) :means ((Wave)))
(Inner () :objective ((seen ?x) {> ?x 1}))
(Wave () :action ({wave})))";

void DecideWithFaults(ProgramMind& mind, const std::string& mode) {
  mind.Input("seen", {kAny});
  mind.Output("wave", {});
  mind.Parameter("faults", mode);
  mind.Load();
  mind.Latch(0, {"seen(word)"});
  mind.Decide();
}

TEST(IcarusReasonerTest, FaultsAreFalseAndTold) {
  ProgramMind mind(kFaulty);
  DecideWithFaults(mind, "false");
  EXPECT_EQ(mind.decision.status, sdk::Status::kProved);
  EXPECT_THAT(mind.decision.message,
              AllOf(HasSubstr("program.icarus:3:33: {>} is given a value of another type"),
                    HasSubstr("(in Inner < Top)")));
  mind.Latch(0, {});
  mind.Decide();
  EXPECT_EQ(mind.decision.message, "");
}

TEST(IcarusReasonerTest, FaultsAbortTheCycle) {
  ProgramMind mind(kFaulty);
  DecideWithFaults(mind, "abort-cycle");
  EXPECT_EQ(mind.decision.status, sdk::Status::kFailed);
  EXPECT_THAT(mind.decision.conclusions, IsEmpty());
  EXPECT_THAT(mind.decision.message, HasSubstr("another type"));
  mind.Latch(0, {});
  EXPECT_THAT(mind.Decide(), ElementsAre("wave"));
}

TEST(IcarusReasonerTest, FaultsStopTheProgram) {
  ProgramMind mind(kFaulty);
  DecideWithFaults(mind, "stop");
  mind.Latch(0, {});
  EXPECT_THAT(mind.Decide(), IsEmpty());
  EXPECT_EQ(mind.decision.status, sdk::Status::kFailed);
  EXPECT_THAT(mind.decision.message, HasSubstr("another type"));
}

}  // namespace
}  // namespace latchwork::icarus::testing
