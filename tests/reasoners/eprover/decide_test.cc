// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "core/process/spawn.h"
#include "reasoners/eprover/eprover_reasoner.h"
#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::eprover {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;
using Answers = sdk::Goal::Answers;
using State = sdk::Assumption::State;
using sdk::Limit;
using sdk::Status;
using Mind = pttp::MindOf<EproverReasoner>;

class EproverTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (process::FindProgram("eprover").empty()) GTEST_SKIP() << "eprover is not installed";
  }
};

TEST_F(EproverTest, AllAnswers_WithNumbersAndQuotedWords) {
  Mind mind(R"(
    fof(step, axiom, ![X,Y] : (edge(X,Y) => path(X,Y))).
    fof(far, axiom, ![X,Y,Z] : ((edge(X,Y) & path(Y,Z)) => path(X,Z))).
  )");
  mind.Input("edge", 2);
  mind.Goal("path(a,X)", Answers::kAll);
  mind.Load();
  mind.Latch(0, {"edge(a,'B 1')", "edge('B 1',-1.5)", "edge(-1.5,f(7))", "edge(f(7),a)"});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), UnorderedElementsAre("path(a, 'B 1')", "path(a, -1.5)",
                                                       "path(a, f(7))", "path(a, a)"));
  mind.Latch(0, {"edge(b,c)"});
  EXPECT_EQ(mind.Decide().status, Status::kRefuted);
}

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

TEST_F(EproverTest, OtherHeuristic_AnswersAlike) {
  Mind mind("fof(a, axiom, ![X] : (in(X) => out(X))).");
  mind.Input("in", 1);
  mind.Goal("out(X)", Answers::kAll);
  mind.Parameter("heuristic", "AutoSched0");
  mind.Load();
  mind.Latch(0, {"in(a)", "in(b)"});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), UnorderedElementsAre("out(a)", "out(b)"));
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

TEST_F(EproverTest, Cancellation_IsHeard) {
  Mind mind("fof(a, axiom, p).");
  mind.Goal("p");
  mind.Load();
  const std::atomic<bool> cancelled = true;
  mind.budget.cancelled = &cancelled;
  EXPECT_EQ(mind.Decide().limit, Limit::kCancelled);
}

TEST_F(EproverTest, ContradictionsAreReportedAndRefused) {
  Mind mind("fof(both, axiom, ~ (hot & cold)). fof(a, axiom, warm => hot).");
  mind.Input("warm", 0);
  mind.Input("cold", 0);
  mind.Goal("hot");
  mind.Load();
  mind.Latch(0, {"warm"});
  mind.Latch(1, {});
  std::vector<sdk::Refusal> refused;
  const std::vector<logic::Fact> batch = {mind.Atom("warm"), mind.Atom("cold")};
  mind.reasoner.Admit(mind.latches, 1, batch, mind.budget, refused);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].index, 1U);
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  mind.Latch(1, {"cold"});
  EXPECT_EQ(mind.Decide().status, Status::kInconsistent);
}

TEST_F(EproverTest, TellAndRetract) {
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

TEST(EproverProgramTest, Absent_SaysWhatToInstall) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  Mind mind("fof(a, axiom, p).");
  mind.Goal("p");
  const auto diagnostics = mind.TryLoad();
  setenv("PATH", path.c_str(), 1);
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_THAT(diagnostics[0].hint, HasSubstr("apt-get install"));
}

}  // namespace
}  // namespace latchwork::eprover
