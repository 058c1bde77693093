// SPDX-License-Identifier: BSD-3-Clause
//
// Programs that are changed while they run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string_view>

#include "tests/reasoners/icarus/program_mind.h"

namespace latchwork::icarus::testing {
namespace {

using sdk::ArgumentType;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Counts its cycles in memory, and goes through a sequence of two steps.
constexpr std::string_view kProgram = R"((top (Top))
(facts (count 0))
(constant *STEP* 1)
(Top () :requires ((CountOn) (Steps)))
(CountOn () :objective ((count ?n) (bind ?m {+ ?n *STEP*}) (SetCount ?n ?m)))
(SetCount (?n ?m) :sensor ({update (count ?n) (count ?m)}))
(Steps () :sequence ((First) (Second)))
(First () :objective ((done first)) :means ((Say one)))
(Second () :objective ((done second)) :means ((Say two)))
(Say (?x) :action ({say ?x}))
)";

void Prepare(ProgramMind& mind) {
  mind.Input("done", {ArgumentType::kSymbol});
  mind.Output("say", {ArgumentType::kAny});
  mind.Load();
}

TEST(IcarusTellTest, ReplacesSkillsAndGoesOn) {
  ProgramMind mind(kProgram);
  Prepare(mind);
  EXPECT_THAT(mind.Decide(), ElementsAre("say(one)"));
  mind.Latch(0, {"done(first)"});
  EXPECT_THAT(mind.Decide(), ElementsAre("say(two)"));
  const auto told = mind.reasoner.Tell(R"(
(Second () :objective ((done second)) :means ((Tell two)))
(Tell (?x) :requires ((count ?n)) :means ((Say ?n))))");
  ASSERT_THAT(told, IsEmpty()) << Format(told);
  mind.Latch(0, {});
  EXPECT_THAT(mind.Decide(), ElementsAre("say(3)"))
      << "memory and the state of the sequence are kept";
}

TEST(IcarusTellTest, StoresOnlyTheFactsThatAreTold) {
  ProgramMind mind(kProgram);
  Prepare(mind);
  mind.Decide();
  ASSERT_THAT(mind.reasoner.Tell("(facts (done first))"), IsEmpty());
  ASSERT_THAT(mind.reasoner.Tell("(First () :requires ((count ?n)) :means ((Say ?n)))"), IsEmpty());
  EXPECT_THAT(mind.Decide(), ElementsAre("say(2)")) << "the count does not begin anew";
}

TEST(IcarusTellTest, KeepsTheOldProgramOnErrors) {
  ProgramMind mind(kProgram);
  Prepare(mind);
  const auto diagnostics = mind.reasoner.Tell("(Say (?x) :action ({sai ?x}))\n(First :means 1)");
  EXPECT_THAT(Format(diagnostics), HasSubstr("told:2:"));
  EXPECT_THAT(Format(mind.reasoner.Tell("(Say (?x) :action ({sai ?x}))")),
              HasSubstr("told:1:20: error: [I028]"));
  EXPECT_THAT(Format(mind.reasoner.Tell("(Say (?x)")), HasSubstr("told:1:1: error: [I001]"));
  EXPECT_THAT(mind.Decide(), ElementsAre("say(one)"));
}

TEST(IcarusTellTest, ReplacesConstantsAndTheTop) {
  ProgramMind mind(kProgram);
  Prepare(mind);
  ASSERT_THAT(mind.reasoner.Tell("(constant *STEP* 10) (top (Other))\n"
                                 "(Other () :requires ((CountOn) (count ?n)) :means ((Say ?n)))"),
              IsEmpty());
  EXPECT_THAT(mind.Decide(), ElementsAre("say(10)"));
  EXPECT_THAT(mind.Decide(), ElementsAre("say(20)"));
}

TEST(IcarusTellTest, RetractsWhatNothingNeeds) {
  ProgramMind mind(kProgram);
  Prepare(mind);
  EXPECT_THAT(Format(mind.reasoner.Retract("Say")),
              HasSubstr("program.icarus:8:45: error: the skill 'Say' is called here"));
  EXPECT_THAT(Format(mind.reasoner.Retract("Top")), HasSubstr("program.icarus:1:6:"));
  EXPECT_THAT(Format(mind.reasoner.Retract("*step*")), HasSubstr("[I012]"));
  EXPECT_THAT(Format(mind.reasoner.Retract("Stepps")), HasSubstr("did you mean 'Steps'?"));
  ASSERT_THAT(mind.reasoner.Tell("(Top () :requires ((CountOn)) :means ((Say still)))"), IsEmpty());
  EXPECT_THAT(mind.reasoner.Retract("steps"), IsEmpty());
  EXPECT_THAT(Format(mind.reasoner.Retract("steps")), HasSubstr("there is no skill or constant"));
  EXPECT_THAT(mind.Decide(), ElementsAre("say(still)"));
}

TEST(IcarusTellTest, TellingForEverTakesNoMoreAndMore) {
  ProgramMind mind(kProgram);
  Prepare(mind);
  for (int i = 0; i < 300; ++i) {
    ASSERT_THAT(mind.reasoner.Tell("; again\n(First () :means ((Say one)))"), IsEmpty());
  }
  EXPECT_THAT(Format(mind.reasoner.Tell("(First ()")), HasSubstr("told:1:1:"));
  EXPECT_THAT(mind.Decide(), ElementsAre("say(one)"));
}

}  // namespace
}  // namespace latchwork::icarus::testing
