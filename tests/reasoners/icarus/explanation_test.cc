// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/explanation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "tests/reasoners/icarus/program_mind.h"
#include "tests/reasoners/icarus/test_attachments.h"

namespace latchwork::icarus::testing {
namespace {

using sdk::ArgumentType;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// `line: conclusion <- premises`, a step a text.
std::vector<std::string> Steps(ProgramMind& mind, std::size_t conclusion) {
  std::vector<std::string> texts;
  for (const auto& step : mind.reasoner.Explain(conclusion).steps) {
    std::string text = std::to_string(step.place.line) + ": " + step.conclusion;
    for (const std::size_t premise : step.premises) text += " <- " + std::to_string(premise);
    texts.push_back(text);
  }
  return texts;
}

TEST(IcarusExplanationTest, TellsTheSkillsAndWhatTheyRestOn) {
  ProgramMind mind(R"((top (Follow))
(Follow ()
  :objective ((seen nobody ?))
  :requires  ((*not* (seen eve ?))
              (seen ?who ?n)
              (Fair ?n ?half))
  :means     ((GoTo ?who ?half)))
(Fair (?n ?half)
  :objective ((bind (?half ?rest) {halves ?n})
              {= ?rest 0}))
(GoTo (?who ?n) :action ({go ?who ?n})))");
  mind.Input("seen", {ArgumentType::kSymbol, ArgumentType::kInteger});
  mind.Output("go", {ArgumentType::kSymbol, ArgumentType::kInteger});
  mind.attachments = {std::make_shared<Halves>()};
  mind.Load();
  mind.Latch(0, {"seen(bob, 7)", "seen(anna, 8)"});
  EXPECT_THAT(mind.Decide(), ElementsAre("go(anna, 4)"));
  EXPECT_THAT(
      Steps(mind, 0),
      ElementsAre("1: 'Follow'", "4: ~ seen(eve, X)", "5: seen(anna, 8)", "9: halves(8, 4, 0)",
                  "9: list(4, 0) = halves(8) <- 3", "10: '='(0, 0)", "6: 'Fair'(8, 4) <- 4 <- 5",
                  "7: 'GoTo'(anna, 4) <- 0 <- 1 <- 2 <- 6", "11: go(anna, 4) <- 7"));
  EXPECT_THAT(Steps(mind, 1), IsEmpty());
}

TEST(IcarusExplanationTest, TagsWhatEachStepIs) {
  ProgramMind mind(R"((top (Go))
(facts (left 2) (old 1))
(Go () :requires ((Tidy) (*not* (Blocked)) (left ?n) (bind ?m {+ ?n 1}) {> ?m 2}) :means ((Say ?m)))
(Tidy () :sensor ({forget (old ?)}))
(Blocked () :objective ((wall ahead)))
(Say (?n) :action ({say ?n})))");
  mind.Output("say", {ArgumentType::kInteger});
  mind.Load();
  EXPECT_THAT(mind.Decide(), ElementsAre("say(3)"));
  EXPECT_EQ(sdk::ToText(mind.reasoner.Explain(0)),
            "  'Go'  [skill Go]\n"
            "  forget(old(X))  [change of memory]\n"
            "  'Tidy'  [skill Tidy]\n"
            "  ~ 'Blocked'  [not True]\n"
            "  left(2)  [latch memory]\n"
            "  3 = '+'(2, 1)  [by bind]\n"
            "  '>'(3, 2)  [arithmetic]\n"
            "  'Say'(3)  [skill Say]\n"
            "  say(3)  [skill Say]\n");
}

TEST(IcarusExplanationTest, LeavesMemoryAndSequencesAlone) {
  ProgramMind mind(R"((top (Steps))
(facts (count 0))
(Steps () :sequence ((CountOn) (Say)))
(CountOn () :objective ((count ?n) (bind ?m {+ ?n 1}) (SetCount ?n ?m)))
(SetCount (?n ?m) :sensor ({update (count ?n) (count ?m)}))
(Say () :requires ((CountOn) (count ?n)) :means ((SayIt ?n)))
(SayIt (?n) :action ({say ?n})))");
  mind.Output("say", {ArgumentType::kInteger});
  mind.Load();
  EXPECT_THAT(mind.Decide(), ElementsAre("say(2)"));
  EXPECT_THAT(Steps(mind, 0), IsEmpty()) << "what it rests on has been counted on";
  EXPECT_THAT(mind.Decide(), ElementsAre("say(3)"));
  EXPECT_THAT(mind.decision.message, "");
}

TEST(IcarusExplanationTest, ForgottenFactsOfLatchesAreThereAgain) {
  ProgramMind mind(R"((top (Top))
(Top () :requires ((seen ?x) (Drop ?x)) :means ((Say ?x)))
(Drop (?x) :sensor ({forget (seen ?x)}))
(Say (?x) :action ({say ?x})))");
  mind.Input("seen", {ArgumentType::kSymbol});
  mind.Output("say", {ArgumentType::kSymbol});
  mind.Load();
  mind.Latch(0, {"seen(a)"});
  EXPECT_THAT(mind.Decide(), ElementsAre("say(a)"));
  EXPECT_EQ(Steps(mind, 0).size(), 6U);
  EXPECT_EQ(Steps(mind, 0).size(), 6U) << "once more";
  EXPECT_THAT(mind.Decide(), ElementsAre("say(a)"));
}

}  // namespace
}  // namespace latchwork::icarus::testing
