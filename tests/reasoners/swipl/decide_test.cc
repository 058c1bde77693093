// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/reasoners/swipl/setting.h"

namespace latchwork::swipl {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;
using Answers = sdk::Goal::Answers;
using State = sdk::Assumption::State;
using sdk::Limit;
using sdk::Status;

INSTANTIATE_TYPED_TEST_SUITE_P(Swipl, OutsideProgramTest, Setting);
INSTANTIATE_TYPED_TEST_SUITE_P(Swipl, AbsentProgramTest, Setting);
using SwiplTest = OutsideProgramTest<Setting>;

TEST_F(SwiplTest, CasesAreReduced) {
  Mind mind(R"(
    fof(a, axiom, left | right).
    fof(b, axiom, left => away).
    fof(c, axiom, right => away).
  )");
  mind.Goal("away");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, Status::kProved);
}

TEST_F(SwiplTest, UnificationIsSound) {
  Mind mind("fof(a, axiom, ![X] : p(X, f(X))). fof(b, axiom, ![X] : (p(X, X) => q)).");
  mind.Goal("q");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, Status::kRefuted);
}

TEST_F(SwiplTest, ArithmeticIsComputedWhenItIsGround) {
  Mind mind(R"(
    fof(sum, axiom, ![X,Y] : (($less(X, 3) & in(X) & in(Y)) => out($sum(X, $product(2, Y))))).
    fof(half, axiom, ![X] : (in(X) => half($quotient(X, 2)))).
  )");
  mind.Input("in", 1);
  mind.Goal("out(X)", Answers::kAll);
  mind.Goal("half(X)", Answers::kAll);
  mind.Load();
  mind.Latch(0, {"in(1)", "in(4)", "in(0.5)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(),
              UnorderedElementsAre("out(3)", "out(9)", "out(2.0)", "out(2.5)", "out(8.5)",
                                   "out(1.5)", "half(0.5)", "half(2)", "half(0.25)"));
}

constexpr std::string_view kForward = R"(
fof(forward, axiom, ![V] : ((speed(V) & ~ halt_robot) => fwd(V))).
fof(halt, axiom, ![O] : (ahead(O) => halt_robot)).
)";

TEST_F(SwiplTest, DefaultIsMadeRetractedAndRestored) {
  Mind mind(kForward);
  mind.Input("speed", 1);
  mind.Input("ahead", 1);
  mind.Minimize("halt_robot", 0);
  mind.Goal("fwd(V)");
  mind.Load();
  mind.Latch(0, {"speed(0.5)"});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  ASSERT_EQ(mind.decision.assumptions.size(), 1U);
  EXPECT_EQ(mind.decision.assumptions[0].state, State::kMade);
  EXPECT_THAT(mind.decision.conclusions.at(0).assumptions, ElementsAre(0));
  mind.Latch(1, {"ahead(wall)"});
  EXPECT_EQ(mind.Decide().status, Status::kRefuted);
  EXPECT_EQ(mind.decision.assumptions.at(0).state, State::kRetracted);
  mind.Latch(1, {});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
}

TEST_F(SwiplTest, DefaultThatRestsOnItself_IsUnknown) {
  Mind mind("fof(a, axiom, ~ p => q). fof(b, axiom, ~ q => p).");
  mind.Minimize("p", 0);
  mind.Minimize("q", 0);
  mind.Goal("q");
  mind.Load();
  const Status status = mind.Decide().status;
  EXPECT_EQ(status, Status::kUnknown);
  EXPECT_THAT(mind.decision.message, HasSubstr("rests on itself"));
}

TEST_F(SwiplTest, LiteralThatNeverBecomesGround_IsUnknown) {
  Mind mind("fof(a, axiom, ![X] : ($less(X, 1) => q)).");
  mind.Goal("q");
  mind.Load();
  EXPECT_EQ(mind.Decide().status, Status::kUnknown);
}

constexpr std::string_view kCounting = R"(
fof(zero, axiom, n(z)).
fof(next, axiom, ![X] : (n(X) => n(s(X)))).
)";

TEST_F(SwiplTest, DepthAndInferences_AreLimits) {
  Mind mind(kCounting);
  mind.Goal("n(X)", Answers::kAll);
  mind.Load();
  mind.budget.depth = 4;
  EXPECT_EQ(mind.Decide().status, Status::kUnknown);
  EXPECT_EQ(mind.decision.limit, Limit::kDepth);
  EXPECT_EQ(mind.decision.conclusions.size(), 5U);
  mind.budget.depth = 1000000;
  mind.budget.inferences = 10000;
  EXPECT_EQ(mind.Decide().status, Status::kUnknown);
  EXPECT_EQ(mind.decision.limit, Limit::kInferences);
  const auto found = mind.Conclusions();
  EXPECT_FALSE(found.empty());
  mind.Latch(0, {});
  mind.Decide();
  EXPECT_EQ(mind.Conclusions(), found) << "the same, whatever came before";
}

TEST_F(SwiplTest, WallTime_EndsTheProgram_WhichIsStartedAgain) {
  Mind mind(std::string(kCounting) +
            "fof(q, axiom, in => q). fof(u, axiom, ![X] : ((n(X) & never(X)) => u)).");
  mind.Input("in", 0);
  mind.Input("never", 1);
  mind.Goal("q");
  mind.Goal("u");
  mind.Parameter("seconds", "0.3");
  mind.Load();
  mind.budget.depth = 100000000;
  mind.budget.inferences = 1000000000000;
  mind.Latch(0, {"in"});
  EXPECT_EQ(mind.Decide().limit, Limit::kTime);
  EXPECT_THAT(mind.decision.message, HasSubstr("0.3 s"));
  mind.budget = {};
  mind.budget.depth = 4;
  EXPECT_EQ(mind.Decide().limit, Limit::kDepth);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("q"));
}

TEST_F(SwiplTest, Contradiction_IsReported) {
  Mind mind("fof(both, axiom, ~ (hot & cold)). fof(a, axiom, warm => hot).");
  mind.Input("warm", 0);
  mind.Input("cold", 0);
  mind.Goal("hot");
  mind.Load();
  mind.Latch(0, {"warm", "cold"});
  EXPECT_EQ(mind.Decide().status, Status::kInconsistent);
  EXPECT_THAT(mind.decision.message, HasSubstr("'both'"));
}

TEST_F(SwiplTest, Admit_RefusesWhatContradictsTheBody) {
  Mind mind(R"(
    fof(one, axiom, ![O,A,B] : ~ (distance(O,A) & distance(O,B) & $less(A,B))).
    fof(positive, axiom, ![O,A] : ~ (distance(O,A) & $less(A,0))).
  )");
  mind.Input("distance", 2);
  mind.Goal("distance(a,X)", Answers::kAll);
  mind.Load();
  mind.Latch(0, {"distance(a,1)"});
  mind.Latch(1, {"distance(a,7)"});
  std::vector<sdk::Refusal> refused;
  const std::vector<logic::Fact> batch = {mind.Atom("distance(b,2)"), mind.Atom("distance(b,3)"),
                                          mind.Atom("distance(c,-1)"), mind.Atom("distance(a,1)")};
  mind.reasoner.Admit(mind.latches, 1, batch, mind.budget, refused);
  ASSERT_EQ(refused.size(), 2U);
  EXPECT_EQ(refused[0].index, 1U);
  EXPECT_THAT(refused[0].reason, HasSubstr("'one'"));
  EXPECT_EQ(refused[1].index, 2U);
  EXPECT_THAT(refused[1].reason, HasSubstr("'positive'"));
  mind.Latch(1, {});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("distance(a, 1)"));
}

TEST_F(SwiplTest, Admit_ForgetsWhatFailedBeforeTheLastFact) {
  Mind mind(R"(
    fof(never, axiom, ![I] : ~ (a(I) & path(s,t) & d(I))).
    fof(step, axiom, ![X,Y] : (edge(X,Y) => path(X,Y))).
    fof(back, axiom, ![X,Y] : (path(Y,X) => path(X,Y))).
    fof(d, axiom, ![I] : (e(I) => d(I))).
    fof(e, axiom, e(2)).
  )");
  mind.Input("a", 1);
  mind.Input("edge", 2);
  mind.Goal("path(s,t)");
  mind.Load();
  mind.Latch(0, {});
  std::vector<sdk::Refusal> refused;
  const std::vector<logic::Fact> batch = {mind.Atom("a(1)"), mind.Atom("edge(s,t)"),
                                          mind.Atom("a(2)")};
  mind.reasoner.Admit(mind.latches, 0, batch, mind.budget, refused);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].index, 2U);
}

TEST_F(SwiplTest, Admit_ABatchSpendsOneBudget) {
  Mind mind(R"(
    fof(never, axiom, ![I,X,Y,Z] : ~ (a(I) & n(X) & n(Y) & n(Z) & $less(Z,0))).
    fof(simple, axiom, ~ b(1)).
    fof(one, axiom, n(1)). fof(two, axiom, n(2)). fof(three, axiom, n(3)). fof(four, axiom, n(4)).
    fof(five, axiom, n(5)). fof(six, axiom, n(6)). fof(seven, axiom, n(7)). fof(eight, axiom, n(8)).
  )");
  mind.Input("a", 1);
  mind.Input("b", 1);
  mind.Goal("b(1)");
  mind.Load();
  const auto refused = [&](std::uint64_t inferences) {
    mind.budget.inferences = inferences;
    std::vector<sdk::Refusal> refusals;
    const std::vector<logic::Fact> batch = {mind.Atom("a(1)"), mind.Atom("b(1)")};
    mind.reasoner.Admit(mind.latches, 0, batch, mind.budget, refusals);
    return refusals.size();
  };
  mind.Latch(0, {});
  EXPECT_EQ(refused(10'000), 1U);
  EXPECT_EQ(refused(60), 0U) << "nothing was left for the second";
}

}  // namespace
}  // namespace latchwork::swipl
