// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(BodyTest, UndefinedPredicateIsReportedWithNearestName) {
  AgentMind mind("fof(a, axiom, ![X] : (sonar_readin(X) => near(X))).");
  mind.Input("sonar_reading", 1);
  mind.Goal("near(X)");
  const auto diagnostics = mind.TryLoad();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_THAT(diagnostics[0].message, HasSubstr("sonar_readin/1"));
  EXPECT_THAT(diagnostics[0].hint, HasSubstr("'sonar_reading'"));
  EXPECT_EQ(diagnostics[0].place.line, 1U);
}

TEST(BodyTest, ConjectureIsRefused) {
  AgentMind mind("fof(a, axiom, p). fof(c, conjecture, p).");
  mind.Goal("p");
  const auto diagnostics = mind.TryLoad();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_THAT(diagnostics[0].message, HasSubstr("'c' is a conjecture"));
}

TEST(BodyTest, ToldClauseCountsUntilRetracted) {
  AgentMind mind("fof(a, axiom, ![X] : (cat(X) => pet(X))).");
  mind.Input("cat", 1);
  mind.Goal("pet(X)", sdk::Goal::Answers::kAll);
  mind.Load();
  mind.Latch(0, {"cat(tom)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("pet(tom)"));
  EXPECT_THAT(mind.reasoner.Tell("fof(more, axiom, pet(rex))."), IsEmpty());
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("pet(rex)", "pet(tom)"));
  EXPECT_THAT(mind.reasoner.Retract("more"), IsEmpty());
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("pet(tom)"));
}

TEST(BodyTest, BadTellChangesNothing) {
  AgentMind mind("fof(a, axiom, pet(tom)).");
  mind.Goal("pet(X)", sdk::Goal::Answers::kAll);
  mind.Load();
  EXPECT_EQ(mind.reasoner.Tell("fof(b, axiom, pet(rex)). fof(c, axiom, pet().").size(), 1U);
  EXPECT_EQ(mind.reasoner.Retract("aa").size(), 1U);
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("pet(tom)"));
}

constexpr std::string_view kLaws = R"(
fof(law, axiom, ![X] : ~ (hot(X) & cold(X))).
fof(ice, axiom, ![X] : (ice(X) => cold(X))).
fof(warm, axiom, ![X] : (warm(X) => hot(X))).
)";

TEST(AdmitTest, RefusesWhatContradictsFactByFact) {
  AgentMind mind(kLaws);
  for (const char* name : {"ice", "warm", "other"}) mind.Input(name, 1);
  mind.Goal("hot(X)");
  mind.Load();
  mind.Latch(0, {"ice(a)"});
  mind.Latch(1, {"warm(c)"});
  const std::vector<logic::Fact> batch{mind.Atom("warm(a)"), mind.Atom("warm(b)"),
                                       mind.Atom("ice(b)"), mind.Atom("ice(c)"),
                                       mind.Atom("other(a)")};
  std::vector<sdk::Refusal> refused;
  mind.reasoner.Admit(mind.latches, 1, batch, mind.budget, refused);
  ASSERT_EQ(refused.size(), 2U);
  EXPECT_EQ(refused[0].index, 0U);
  EXPECT_THAT(refused[0].reason, HasSubstr("ice(a)"));
  EXPECT_EQ(refused[1].index, 2U);
  EXPECT_THAT(refused[1].reason, HasSubstr("warm(b)"));
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("hot(c)"));
}

TEST(AdmitTest, DefaultsRefuseNothing) {
  AgentMind mind("fof(a, axiom, (~ busy => idle)). fof(b, axiom, ~ (idle & busy)).");
  mind.Input("busy", 0);
  mind.Minimize("busy", 0);
  mind.Goal("idle");
  mind.Load();
  mind.Latch(0, {});
  const std::vector<logic::Fact> batch{mind.Atom("busy")};
  std::vector<sdk::Refusal> refused;
  mind.reasoner.Admit(mind.latches, 0, batch, mind.budget, refused);
  EXPECT_THAT(refused, IsEmpty());
}

TEST(ExplainTest, NamesClausesLatchesAndAssumptions) {
  AgentMind mind(R"(
fof(forward, axiom, ![V] : ((speed(V) & $less(V, 2) & ~ halt_robot) => fwd(V))).
fof(halt, axiom, ![O] : (ahead(O) => halt_robot)).
)");
  mind.Input("speed", 1);
  mind.Input("ahead", 1);
  mind.Minimize("halt_robot", 0);
  mind.Goal("fwd(V)");
  mind.Load();
  mind.Latch(0, {"speed(1)"});
  mind.Decide();
  const auto derivation = mind.reasoner.Explain(0);
  using Kind = sdk::DerivationStep::Kind;
  ASSERT_EQ(derivation.steps.size(), 4U);
  const auto& last = derivation.steps.back();
  EXPECT_EQ(last.conclusion, "fwd(1)");
  EXPECT_EQ(last.source, "forward");
  EXPECT_EQ(last.premises.size(), 3U);
  std::vector<Kind> kinds;
  for (const std::size_t premise : last.premises) kinds.push_back(derivation.steps[premise].kind);
  EXPECT_THAT(kinds,
              ::testing::UnorderedElementsAre(Kind::kLatch, Kind::kArithmetic, Kind::kAssumption));
}

}  // namespace
}  // namespace latchwork::pttp
