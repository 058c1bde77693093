// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/process/spawn.h"
#include "reasoners/eprover/eprover_reasoner.h"
#include "tests/reasoners/outside_program.h"
#include "tests/temporary_folder.h"

namespace latchwork::eprover {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;
using Answers = sdk::Goal::Answers;
using State = sdk::Assumption::State;
using sdk::Limit;
using sdk::Status;
using Mind = pttp::MindOf<EproverReasoner>;

struct Setting {
  using Reasoner = EproverReasoner;
  static constexpr const char* kProgram = "eprover";
  static constexpr const char* kPackage = "eprover";
};
INSTANTIATE_TYPED_TEST_SUITE_P(Eprover, OutsideProgramTest, Setting);
INSTANTIATE_TYPED_TEST_SUITE_P(Eprover, AbsentProgramTest, Setting);
using EproverTest = OutsideProgramTest<Setting>;

TEST_F(EproverTest, Disjunctions) {
  Mind mind(R"(
    fof(a, axiom, at(left) | at(right)).
    fof(b, axiom, ![X] : (at(X) => away)).
  )");
  mind.Goal("away");
  mind.Goal("at(X)", Answers::kAll);
  mind.Load();
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("away"));
}

TEST_F(EproverTest, FirstAnswer_BehindIndefiniteOnes) {
  Mind mind(R"(
    fof(a, axiom, at(left) | at(right)).
    fof(b, axiom, start(home)).
    fof(c, axiom, ![X] : (start(X) => way(f(X)))).
    fof(d, axiom, ![X] : (way(X) => way_on(g(X)))).
    fof(e, axiom, ![X] : (way_on(X) => at(middle))).
  )");
  mind.Goal("at(X)");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("at(middle)"));
}

TEST_F(EproverTest, IndefiniteAnswersAlone_AreRefuted) {
  Mind mind("fof(a, axiom, at(left) | at(right)).");
  mind.Goal("at(X)");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, Status::kRefuted);
}

TEST_F(EproverTest, DistinctObjectsThatLookLikeDisguisedNumbers) {
  Mind mind("fof(a, axiom, ![X] : (in(X) => out(X))).");
  mind.Input("in", 1);
  mind.Goal("out(X)", Answers::kAll);
  mind.Load();
  mind.Latch(0, {"in(5)", "in(\"#5\")", "in(\"##5\")"});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), UnorderedElementsAre("out(5)", "out(\"#5\")", "out(\"##5\")"));
}

TEST_F(EproverTest, DefaultUnderAnEquation_IsClosed) {
  Mind mind(R"(
    fof(a, axiom, a = b | ab).
    fof(b, axiom, f(a)).
    fof(c, axiom, ![X] : (f(X) => p(X))).
  )");
  mind.Minimize("ab", 0);
  mind.Goal("p(b)");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  ASSERT_EQ(mind.decision.assumptions.size(), 1U);
}

/// A program in front of E that keeps what E is called with.
std::string CommandFor(const std::string& heuristic) {
  const test::TemporaryFolder folder;
  const std::filesystem::path kept = folder.path() / "command";
  const auto program =
      folder.Write("eprover", fmt::format("#!/bin/sh\necho \"$*\" > '{}'\nexec '{}' \"$@\"\n",
                                          kept.string(), process::FindProgram("eprover").string()));
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const PathGuard guard(folder.path().string());
  Mind mind("fof(a, axiom, ![X] : (in(X) => out(X))).");
  mind.Input("in", 1);
  mind.Goal("out(X)", Answers::kAll);
  mind.Parameter("heuristic", heuristic);
  mind.Load();
  mind.Latch(0, {"in(a)", "in(b)"});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), UnorderedElementsAre("out(a)", "out(b)"));
  std::string command;
  std::ifstream stream(kept);
  std::getline(stream, command);
  return command;
}

TEST_F(EproverTest, HeuristicIsGivenToE) {
  EXPECT_THAT(CommandFor("Auto"), AllOf(HasSubstr(" --satauto "), Not(HasSubstr(" -x"))));
  for (const std::string heuristic : {"AutoSched0", "AutoSched3"}) {
    EXPECT_THAT(CommandFor(heuristic),
                AllOf(HasSubstr(" -x " + heuristic + " "), Not(HasSubstr("--satauto"))));
  }
}

TEST_F(EproverTest, DefaultsByFactsAndByRules) {
  Mind mind(R"(
    fof(open, axiom, ![E] : ((door(E) & ~ shut(E)) => open(E))).
    fof(shut, axiom, ![E,F] : ((door(E) & next(E, F) & locked(F)) => shut(E))).
  )");
  mind.Input("door", 1);
  mind.Input("next", 2);
  mind.Input("locked", 1);
  mind.Input("shut", 1);
  mind.Minimize("shut", 1);
  mind.Goal("open(E)", Answers::kAll);
  mind.Load();
  mind.Latch(0, {"door(a)", "door(b)", "next(a,b)", "next(b,a)", "locked(a)"});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("open(a)"));
  ASSERT_EQ(mind.decision.assumptions.size(), 2U);
  EXPECT_EQ(mind.decision.assumptions[0].state, State::kMade);
  EXPECT_EQ(mind.decision.assumptions[1].state, State::kRetracted);
  mind.Latch(0, {"door(a)", "shut(a)"});
  EXPECT_EQ(mind.Decide().status, Status::kRefuted);
}

TEST_F(EproverTest, DefaultThatRestsOnItself_IsRefused) {
  Mind mind("fof(a, axiom, ~ p => q). fof(b, axiom, ~ q => p).");
  mind.Minimize("p", 0);
  mind.Minimize("q", 0);
  mind.Goal("q");
  const auto diagnostics = mind.TryLoad();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_THAT(diagnostics[0].message, HasSubstr("rests on itself"));
}

TEST_F(EproverTest, ArithmeticIsRefused_WithItsPlace) {
  Mind mind("fof(a, axiom, ![X] : ((p(X) & $less(X, 1)) => q)).");
  mind.Input("p", 1);
  mind.Goal("q");
  const auto diagnostics = mind.TryLoad();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_THAT(diagnostics[0].message, HasSubstr("arithmetic"));
  EXPECT_EQ(diagnostics[0].place.line, 1U);
}

TEST_F(EproverTest, WithoutEnd_IsALimit) {
  Mind mind("fof(zero, axiom, n(z)). fof(next, axiom, ![X] : (n(X) => n(s(X)))).");
  mind.Goal("n(X)", Answers::kAll);
  mind.Parameter("clauses", "100");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, Status::kUnknown);
  EXPECT_EQ(mind.decision.limit, Limit::kInferences);
  EXPECT_FALSE(mind.decision.conclusions.empty());
}

TEST_F(EproverTest, ToldWhatECannotTake_StaysAsItWas) {
  Mind mind("fof(a, axiom, p => q).");
  mind.Input("p", 0);
  mind.Goal("q");
  mind.Load();
  mind.Latch(0, {});
  EXPECT_EQ(mind.Decide().status, Status::kRefuted);
  EXPECT_THAT(mind.reasoner.Tell("fof(b, axiom, q)."), IsEmpty());
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_FALSE(mind.reasoner.Tell("fof(c, axiom, ![X] : ($less(X, 1) => q)).").empty());
  EXPECT_THAT(mind.reasoner.Retract("b"), IsEmpty());
  EXPECT_EQ(mind.Decide().status, Status::kRefuted);
}

}  // namespace
}  // namespace latchwork::eprover
