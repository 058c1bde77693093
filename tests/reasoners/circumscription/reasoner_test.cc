// SPDX-License-Identifier: BSD-3-Clause
//
// The engine as the reasoner of a layer: what it concludes, assumes, retracts and refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "tests/reasoners/circumscription/circumscribing_mind.h"
#include "tests/reasoners/icarus/test_attachments.h"

namespace latchwork::circumscription {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using State = sdk::Assumption::State;

constexpr const char* kReflex =
    "fof(halt, axiom, ! [O] : ((object(O) & near(O)) => halt_robot)).\n"
    "fof(near, axiom, ! [O, D] : ((distance(O, D) & $less(D, 0.5)) => near(O))).\n"
    "fof(echo, axiom, ! [N, D] : (sonar(N, D) => (object(obj(N)) & distance(obj(N), "
    "$sum(D, 0.25))))).\n"
    "fof(go, axiom, ! [V] : ((~ halt_robot & speed(V)) => fwd(V))).\n"
    "fof(stop, axiom, halt_robot => halt).\n"
    "fof(one, axiom, ! [O, A, B] : ~ (distance(O, A) & distance(O, B) & $less(A, B))).\n";

void LoadReflex(CircumscribingMind& mind) {
  mind.Input("sonar", 2);
  mind.Input("speed", 1);
  mind.Input("object", 1);
  mind.Input("distance", 2);
  mind.Minimize("halt_robot", 0);
  mind.Minimize("object", 1);
  mind.Minimize("distance", 2);
  mind.Goal("fwd(V)");
  mind.Goal("halt");
  mind.Parameter("mode", "exact");
  mind.Load();
}

TEST(CircumscriptionReasonerTest, AttachmentCalls_AreThoseOfTheDecision) {
  CircumscribingMind mind(
      "fof(half, axiom, ! [N, H, R] : ((number(N) & halves(N, H, R)) => half(H))).");
  mind.Input("number", 1);
  mind.body.attachments.push_back(std::make_shared<icarus::testing::Halves>());
  mind.Goal("half(H)");
  mind.Parameter("mode", "exact");
  mind.Load();
  for (const int number : {4, 6, 8}) {
    mind.Latch(0, {"number(" + std::to_string(number) + ")"});
    EXPECT_EQ(mind.Decide().statistics.attachment_calls, 1U) << number;
  }
}

TEST(CircumscriptionReasonerTest, ConcludesFromADefault) {
  CircumscribingMind mind(kReflex);
  LoadReflex(mind);
  mind.Latch(0, {"sonar(3, 1.5)", "speed(0.3)"});
  mind.Latch(1, {});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("fwd(0.3)"));
  ASSERT_EQ(mind.decision.assumptions.size(), 1U);
  EXPECT_EQ(ToString(mind.decision.assumptions[0].atom), "halt_robot");
  EXPECT_EQ(mind.decision.assumptions[0].state, State::kMade);
  EXPECT_THAT(mind.decision.conclusions[0].assumptions, ElementsAre(0U));
}

TEST(CircumscriptionReasonerTest, RetractsTheDefaultAndRestoresIt) {
  CircumscribingMind mind(kReflex);
  LoadReflex(mind);
  mind.Latch(0, {"sonar(3, 1.5)", "speed(0.3)"});
  mind.Latch(1, {"object(ghost)", "distance(ghost, 0.1)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("halt"));
  ASSERT_EQ(mind.decision.assumptions.size(), 1U);
  EXPECT_EQ(mind.decision.assumptions[0].state, State::kRetracted);
  EXPECT_THAT(mind.decision.conclusions[0].assumptions, IsEmpty());
  mind.Latch(1, {});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("fwd(0.3)"));
}

TEST(CircumscriptionReasonerTest, FunctionTermsAndArithmeticAreGround) {
  CircumscribingMind mind(kReflex);
  LoadReflex(mind);
  mind.Latch(0, {"sonar(3, 0.125)", "speed(0.3)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("halt"));
  const sdk::Derivation derivation = mind.reasoner.Explain(0);
  std::vector<std::string> steps;
  for (const auto& step : derivation.steps) steps.push_back(step.conclusion);
  EXPECT_THAT(steps, ElementsAre("sonar(3, 0.125)", "object(obj(3))", "distance(obj(3), 0.375)",
                                 "near(obj(3))", "halt_robot", "halt"));
  EXPECT_EQ(derivation.steps.front().kind, sdk::DerivationStep::Kind::kLatch);
  EXPECT_EQ(derivation.steps.front().source, "latch0");
  EXPECT_EQ(derivation.steps.back().source, "stop");
  EXPECT_EQ(derivation.steps.back().place.line, 5U);
}

TEST(CircumscriptionReasonerTest, ContradictionConcludesNothing) {
  CircumscribingMind mind(kReflex);
  LoadReflex(mind);
  mind.Latch(0, {"distance(a, 1)", "distance(a, 2)", "distance(b, 1)", "speed(0.3)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kInconsistent);
  EXPECT_THAT(mind.decision.message, HasSubstr("'one' with distance(a, 1), distance(a, 2)"));
  EXPECT_THAT(mind.Conclusions(), IsEmpty());
}

TEST(CircumscriptionReasonerTest, RefusesAtTheGateWhatHardAxiomsDeny) {
  CircumscribingMind mind(kReflex);
  LoadReflex(mind);
  mind.Latch(0, {"sonar(3, 1.5)"});
  mind.Latch(1, {});
  const std::array batch{mind.Atom("distance(obj(3), 2.0)"), mind.Atom("object(ghost)")};
  std::vector<sdk::Refusal> refused;
  mind.reasoner.Admit(mind.latches, 1, batch, mind.budget, refused);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].index, 0U);
  EXPECT_THAT(refused[0].reason, HasSubstr("'one'"));
}

TEST(CircumscriptionReasonerTest, RecursionOverConstantsIsExact) {
  CircumscribingMind mind(
      "fof(step, axiom, ! [X, Y] : (edge(X, Y) => reach(X, Y))).\n"
      "fof(far, axiom, ! [X, Y, Z] : ((reach(X, Y) & reach(Y, Z)) => reach(X, Z))).\n"
      "fof(lost, axiom, ! [X] : ((place(X) & ~ reach(home, X)) => lost(X))).\n");
  mind.Input("edge", 2);
  mind.Input("place", 1);
  mind.Minimize("reach", 2);
  mind.Goal("lost(X)", sdk::Goal::Answers::kAll);
  mind.Parameter("mode", "exact");
  mind.Load();
  mind.Latch(0, {"edge(home, a)", "edge(a, b)", "edge(b, c)", "edge(d, e)", "place(c)", "place(e)",
                 "place(d)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("lost(e)", "lost(d)"));
}

constexpr const char* kPlan =
    "fof(now, axiom, ! [P] : (here(P) => at(P, s0))).\n"
    "fof(go, axiom, ! [P, Q, S] : ((way(P, Q) & at(P, S)) => at(Q, do(go(Q), S)))).\n"
    "fof(done, axiom, ! [S] : (at(shop, S) => plan(S))).\n";

void LoadPlan(CircumscribingMind& mind) {
  mind.Input("here", 1);
  mind.Input("way", 2);
  mind.Goal("plan(S)");
}

TEST(CircumscriptionReasonerTest, EndlessTermsAreRefusedInModeExact) {
  CircumscribingMind mind(kPlan);
  LoadPlan(mind);
  mind.Parameter("mode", "exact");
  const auto diagnostics = mind.TryLoad();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics[0].place.line, 2U);
  EXPECT_THAT(diagnostics[0].message, HasSubstr("'go' cannot be grounded: it is recursive"));
}

TEST(CircumscriptionReasonerTest, EndlessTermsAreBoundedInModeAuto) {
  CircumscribingMind mind(kPlan);
  LoadPlan(mind);
  mind.Load();
  EXPECT_FALSE(mind.reasoner.is_exact());
  mind.Latch(0, {"here(home)", "way(home, shop)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("plan(do(go(shop), s0))"));
  EXPECT_THAT(mind.decision.message, HasSubstr("bounded: 'go' cannot be grounded"));
}

TEST(CircumscriptionReasonerTest, UnboundVariablesAreRefusedWithTheirNames) {
  CircumscribingMind mind("fof(any, axiom, ! [Where] : (start => open(Where))).");
  mind.Input("start", 0);
  mind.Goal("open(X)");
  mind.Parameter("mode", "exact");
  const auto diagnostics = mind.TryLoad();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_THAT(diagnostics[0].message, HasSubstr("variable 'Where' takes its values from no"));
}

TEST(CircumscriptionReasonerTest, TellAndRetractChangeTheBodyOrNothing) {
  CircumscribingMind mind("fof(rule, axiom, ! [X] : (q(X) => p(X))).");
  mind.Input("q", 1);
  mind.Goal("p(X)", sdk::Goal::Answers::kAll);
  mind.Parameter("mode", "exact");
  mind.Load();
  mind.Latch(0, {"q(a)"});
  EXPECT_THAT(mind.reasoner.Tell("fof(more, axiom, ! [X] : (q(X) => p(f(X))))."), IsEmpty());
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("p(a)", "p(f(a))"));
  EXPECT_THAT(mind.reasoner.Tell("fof(loop, axiom, ! [X] : (p(X) => p(f(X))))."),
              ::testing::SizeIs(1));
  EXPECT_THAT(mind.reasoner.Retract("more"), IsEmpty());
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("p(a)"));
  EXPECT_THAT(mind.reasoner.Retract("more"), ::testing::SizeIs(1));
}

}  // namespace
}  // namespace latchwork::circumscription
