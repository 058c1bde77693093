// SPDX-License-Identifier: BSD-3-Clause
//
// What a program lets into its latches.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tests/reasoners/icarus/program_mind.h"

namespace latchwork::icarus::testing {
namespace {

using sdk::ArgumentType;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::string_view kProgram = R"((top (Top))
(facts (limit 10))
(Top () :requires ((Note) (size ?n)) :means ((Say ?n)))
(Note () :sensor ({store (size 3)}))
(Say (?n) :action ({say ?n}))
(TooLarge (?n) :objective ((limit ?most) {> ?n ?most}))
(never (size ?n) (TooLarge ?n))
(never (size ?a) (size ?b) {< ?a ?b})
(never (wall)
       (size ?))
)";

struct Gate {
  explicit Gate(std::string_view program) : mind(program) {
    mind.Input("size", {ArgumentType::kInteger});
    mind.Input("wall", {});
    mind.Output("say", {ArgumentType::kAny});
  }

  std::vector<std::size_t> Refused(std::size_t port, const std::vector<std::string>& batch) {
    std::vector<logic::Fact> facts;
    for (const std::string& text : batch) facts.push_back(mind.Fact(text));
    refusals.clear();
    mind.reasoner.Admit(mind.latches, port, facts, mind.budget, refusals);
    std::vector<std::size_t> indices;
    for (const sdk::Refusal& refusal : refusals) indices.push_back(refusal.index);
    return indices;
  }

  ProgramMind mind;
  std::vector<sdk::Refusal> refusals;
};

struct IcarusAdmissionTest : ::testing::Test {
  IcarusAdmissionTest() {
    gate.mind.Load();
    gate.mind.Latch(0, {});
    gate.mind.Latch(1, {});
  }
  Gate gate{kProgram};
};

TEST_F(IcarusAdmissionTest, FactThatMakesSomethingTrueThatIsNeverToBe_Refused) {
  EXPECT_THAT(gate.Refused(0, {"size(11)", "size(4)", "size(5)", "size(4)"}), ElementsAre(0, 2));
  EXPECT_THAT(gate.refusals[0].reason, HasSubstr("contradicts (never (size ?n) (TooLarge ?n)) ("));
  EXPECT_THAT(gate.refusals[0].reason, HasSubstr("program.icarus:7)"));
}

TEST_F(IcarusAdmissionTest, OtherLatchesCount_AndTheSameIsReplaced) {
  gate.mind.Latch(0, {"size(4)"});
  EXPECT_THAT(gate.Refused(0, {"size(5)"}), IsEmpty());
  EXPECT_THAT(gate.Refused(1, {"wall"}), ElementsAre(0));
  EXPECT_THAT(gate.refusals[0].reason, HasSubstr("(never (wall) (size ?))"));
  gate.mind.Latch(0, {});
  EXPECT_THAT(gate.Refused(1, {"wall"}), IsEmpty());
}

TEST_F(IcarusAdmissionTest, WhatIsTrueAlready_IsNotHeldAgainstAFact) {
  gate.mind.Latch(0, {"size(4)"});
  gate.mind.Latch(1, {"wall"});
  EXPECT_THAT(gate.Refused(1, {}), IsEmpty());
  EXPECT_THAT(gate.Refused(0, {"size(5)"}), ElementsAre(0));
  gate.mind.Latch(0, {"size(11)"});
  gate.mind.Latch(1, {});
  EXPECT_THAT(gate.Refused(1, {"wall"}), ElementsAre(0));
}

TEST_F(IcarusAdmissionTest, WhatTheProgramNoted_DoesNotCount) {
  EXPECT_THAT(gate.mind.Decide(), ElementsAre("say(3)"));
  EXPECT_THAT(gate.Refused(0, {"size(4)"}), IsEmpty());
  EXPECT_THAT(gate.mind.Decide(), ElementsAre("say(3)")) << "nor does asking change memory";
}

TEST_F(IcarusAdmissionTest, CheckBeyondTheBudget_Admits) {
  gate.mind.budget.inferences = 1;
  EXPECT_THAT(gate.Refused(0, {"size(11)"}), IsEmpty());
}

TEST_F(IcarusAdmissionTest, NeversAreTold) {
  ASSERT_THAT(gate.mind.reasoner.Tell("(never (size 4))"), IsEmpty());
  EXPECT_THAT(gate.Refused(0, {"size(4)", "size(11)"}), ElementsAre(0, 1));
  EXPECT_THAT(Format(gate.mind.reasoner.Retract("TooLarge")), HasSubstr("is called here"));
}

TEST(IcarusAdmissionErrorTest, NeversAreChecked) {
  Gate gate("(top (A))\n(A () :action ({say 1}))\n(never (syze 4))\n(never {far})");
  const std::string problems = Format(gate.mind.TryLoad());
  EXPECT_THAT(problems, HasSubstr("program.icarus:3:9: error: [I032]"));
  EXPECT_THAT(problems, HasSubstr("program.icarus:4:8: error: [I028]"));
}

}  // namespace
}  // namespace latchwork::icarus::testing
