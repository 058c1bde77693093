// SPDX-License-Identifier: BSD-3-Clause
//
// Why a default was made, what retracted it, and what a goal lacks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/reasoners/circumscription/circumscribing_mind.h"
#include "tests/reasoners/pttp/reflex_setting.h"

namespace latchwork::circumscription {
namespace {

class ExplanationTest : public ::testing::Test {
 protected:
  ExplanationTest() : mind_(pttp::kReflex) {
    mind_.Parameter("mode", "exact");
    pttp::PrepareReflex(mind_);
  }

  CircumscribingMind mind_;
};

TEST_F(ExplanationTest, DefaultsAreMadeForWhatClausesLack) {
  mind_.Latch(1, {"object(box)", "distance(box, 0.75)"});
  mind_.Decide();
  const auto explanation = mind_.reasoner.ExplainAssumption(0);
  ASSERT_TRUE(explanation.has_value());
  EXPECT_EQ(ToText(*explanation),
            "nothing concludes halt_robot:\n"
            "  'ahead' has 3 of 4 premises and lacks $less(0.75, 0.5)\n"
            "  'touched' has 0 of 1 premises and lacks bumper\n");
  const std::string expected =
      "{\"subject\":\"halt_robot\",\"holds\":false,\"misses\":["
      "{\"clause\":\"ahead\",\"line\":1,\"met\":3,\"premises\":4,\"lacks\":\"$less(0.75, 0.5)\"},"
      "{\"clause\":\"touched\",\"line\":3,\"met\":0,\"premises\":1,\"lacks\":\"bumper\"}]}";
  EXPECT_EQ(ToJson(*explanation), expected);
}

TEST_F(ExplanationTest, RetractionsNameTheFactsAndPortsBehindThem) {
  mind_.Latch(1, {"object(box)", "distance(box, 0.25)"});
  mind_.Decide();
  const auto explanation = mind_.reasoner.ExplainAssumption(0);
  ASSERT_TRUE(explanation.has_value());
  EXPECT_EQ(ToText(*explanation),
            "halt_robot holds:\n"
            "  object(box)  [latch latch1]\n"
            "  distance(box, 0.25)  [latch latch1]\n"
            "  gap(0.5)  [latch latch0]\n"
            "  halt_robot  [clause ahead]\n");
  EXPECT_THAT(ToJson(*explanation),
              ::testing::HasSubstr("\"kind\":\"latch\",\"source\":\"latch1\""));
}

TEST_F(ExplanationTest, GoalsLackTheNearestPiece) {
  mind_.Latch(1, {"bumper"});
  mind_.Decide();
  const auto explanation = mind_.reasoner.WhyNot(mind_.body.goals[0].pattern);
  ASSERT_TRUE(explanation.has_value());
  EXPECT_EQ(ToText(*explanation),
            "nothing concludes fwd(X0):\n"
            "  'go' has 0 of 2 premises and lacks ~ halt_robot\n");
  mind_.Latch(1, {});
  mind_.Decide();
  EXPECT_TRUE(mind_.reasoner.WhyNot(mind_.body.goals[0].pattern)->holds);
}

/// A theory that needs a search: which way to go is open, and penguins do not fly.
class SearchedExplanationTest : public ::testing::Test {
 protected:
  SearchedExplanationTest()
      : mind_(
            "fof(some, axiom, ! [M] : (move(M) => (push(left) | push(right)))).\n"
            "fof(told, axiom, ! [D] : (order(D) => push(D))).\n"
            "fof(slow, axiom, ! [D] : (push(D) => slow)).\n"
            "fof(birds, axiom, ! [X] : ((bird(X) & ~ abnormal(X)) => flies(X))).\n"
            "fof(penguins, axiom, ! [X] : ~ (penguin(X) & flies(X))).\n") {
    for (const char* name : {"move", "order", "bird", "penguin"}) mind_.Input(name, 1);
    mind_.Minimize("push", 1);
    mind_.Minimize("abnormal", 1);
    mind_.Goal("push(D)", sdk::Goal::Answers::kAll);
    mind_.Goal("flies(X)", sdk::Goal::Answers::kAll);
    mind_.Goal("slow");
    mind_.Parameter("mode", "exact");
    mind_.Load();
  }

  std::string TextOf(std::size_t assumption) {
    const auto explanation = mind_.reasoner.ExplainAssumption(assumption);
    return explanation ? ToText(*explanation) : "none";
  }

  CircumscribingMind mind_;
};

TEST_F(SearchedExplanationTest, AssumptionsNameWhatClausesLackInEveryWorld) {
  mind_.Latch(0, {"move(on)", "bird(opus)", "bird(tweety)", "penguin(opus)"});
  mind_.Decide();
  ASSERT_EQ(mind_.decision.assumptions.size(), 2U);
  EXPECT_EQ(TextOf(0),
            "abnormal(opus) holds:\n"
            "  bird(opus)  [latch latch0]\n"
            "  penguin(opus)  [latch latch0]\n"
            "  ~ bird(X) | abnormal(X) | flies(X)  [clause birds]\n"
            "  ~ penguin(X) | ~ flies(X)  [clause penguins]\n"
            "  abnormal(opus)  [reduction minimal models]\n");
  EXPECT_EQ(TextOf(1),
            "nothing concludes abnormal(tweety):\n"
            "  'birds' has 1 of 2 premises and lacks ~ flies(tweety)\n");
  EXPECT_EQ(TextOf(2), "none");
}

TEST_F(SearchedExplanationTest, OpenGoalsShowAWorldWithoutThem) {
  mind_.Latch(0, {"move(on)"});
  mind_.Decide();
  const auto explanation = mind_.reasoner.WhyNot(mind_.Atom("push(left)"));
  ASSERT_TRUE(explanation.has_value());
  EXPECT_EQ(ToText(*explanation),
            "nothing concludes push(left):\n"
            "  'some' has 1 of 2 premises and lacks ~ push(right)\n"
            "  'told' has 0 of 1 premises and lacks order(left)\n"
            "  some minimal world has ~ push(left), push(right)\n");
  EXPECT_EQ(ToJson(*explanation),
            "{\"subject\":\"push(left)\",\"holds\":false,\"misses\":["
            "{\"clause\":\"some\",\"line\":1,\"met\":1,\"premises\":2,"
            "\"lacks\":\"~ push(right)\"},"
            "{\"clause\":\"told\",\"line\":2,\"met\":0,\"premises\":1,"
            "\"lacks\":\"order(left)\"}],\"world\":[\"~ push(left)\",\"push(right)\"]}");
  EXPECT_TRUE(mind_.reasoner.WhyNot(mind_.Atom("slow"))->holds);
}

TEST_F(SearchedExplanationTest, GoalsThatNoWorldHasLackTheNearestPiece) {
  mind_.Latch(0, {"move(on)", "bird(opus)", "penguin(opus)"});
  mind_.Decide();
  EXPECT_EQ(ToText(*mind_.reasoner.WhyNot(mind_.Atom("flies(opus)"))),
            "nothing concludes flies(opus):\n"
            "  'birds' has 1 of 2 premises and lacks ~ abnormal(opus)\n");
  EXPECT_EQ(ToText(*mind_.reasoner.WhyNot(mind_.Atom("flies(rex)"))),
            "nothing concludes flies(rex):\n"
            "  'birds' has 0 of 1 premises and lacks bird(rex)\n");
}

TEST_F(SearchedExplanationTest, AskingDoesNotChangeLaterCycles) {
  mind_.Latch(0, {"move(on)", "bird(opus)"});
  mind_.Decide();
  const std::string before = ToText(*mind_.reasoner.WhyNot(mind_.Atom("push(left)")));
  EXPECT_EQ(ToText(*mind_.reasoner.WhyNot(mind_.Atom("push(left)"))), before);
  mind_.Latch(0, {"move(on)", "order(left)"});
  mind_.Decide();
  EXPECT_TRUE(mind_.reasoner.WhyNot(mind_.Atom("push(left)"))->holds);
  mind_.Latch(0, {"move(on)", "bird(opus)"});
  mind_.Decide();
  EXPECT_EQ(ToText(*mind_.reasoner.WhyNot(mind_.Atom("push(left)"))), before);
}

/// Asks about near(b, c), which holds; a search is needed while `move` does.
class PatternTest : public ::testing::Test {
 protected:
  PatternTest()
      : mind_(
            "fof(near, axiom, ! [X, Y] : (seen(X, Y) => near(X, Y))).\n"
            "fof(some, axiom, ! [M] : (move(M) => (push(left, M) | push(right, M)))).\n") {
    mind_.Input("seen", 2);
    mind_.Input("move", 1);
    mind_.Minimize("push", 2);
    mind_.Goal("near(X, Y)", sdk::Goal::Answers::kAll);
    mind_.Goal("push(X, Y)", sdk::Goal::Answers::kAll);
    mind_.Parameter("mode", "exact");
    mind_.Load();
    mind_.Latch(0, {"seen(b, c)", "seen(f(b, b), d)"});
  }

  void DecideWith(const std::vector<std::string>& facts) {
    mind_.Latch(1, facts);
    mind_.Decide();
  }

  std::string TextOf(const char* pattern) {
    const auto explanation = mind_.reasoner.WhyNot(mind_.Atom(pattern));
    return explanation ? ToText(*explanation) : "none";
  }

  void ExpectOnlyInstancesAnswer() {
    for (const char* pattern : {"near(a, X)", "near(X, X)", "near(f(X, Y), Y)", "near(c, b)"}) {
      EXPECT_THAT(TextOf(pattern), ::testing::StartsWith("nothing concludes")) << pattern;
    }
    for (const char* pattern : {"near(b, X)", "near(X, Y)", "near(b, c)"}) {
      EXPECT_THAT(TextOf(pattern), ::testing::HasSubstr("seen(b, c)  [latch latch0]")) << pattern;
    }
    EXPECT_THAT(TextOf("near(f(X, X), Y)"),
                ::testing::HasSubstr("seen(f(b, b), d)  [latch latch0]"));
  }

  CircumscribingMind mind_;
};

TEST_F(PatternTest, OnlyItsInstancesAnswerWithoutASearch) {
  DecideWith({});
  ExpectOnlyInstancesAnswer();
}

TEST_F(PatternTest, OnlyItsInstancesAnswerAfterASearch) {
  DecideWith({"move(on)"});
  ExpectOnlyInstancesAnswer();
}

TEST_F(PatternTest, WorldsAreShownForItsInstancesOnly) {
  DecideWith({"move(on)"});
  EXPECT_THAT(TextOf("push(left, X)"), ::testing::HasSubstr("some minimal world"));
  EXPECT_EQ(TextOf("push(up, X)"), "nothing concludes push(up, X0), and no clause could\n");
}

TEST_F(PatternTest, RepeatedVariablesAreWhatClausesLack) {
  for (const std::vector<std::string>& facts : {std::vector<std::string>{}, {"move(on)"}}) {
    DecideWith(facts);
    EXPECT_EQ(TextOf("near(X, X)"),
              "nothing concludes near(X0, X0):\n"
              "  'near' has 0 of 1 premises and lacks seen(Y, Y)\n");
    EXPECT_EQ(TextOf("near(f(X, Y), Y)"),
              "nothing concludes near(f(X0, X1), X1):\n"
              "  'near' has 0 of 1 premises and lacks seen(f(X2, Y), Y)\n");
  }
}

TEST(PatternsOfOneClauseTest, WhatItCannotConcludeIsNoMiss) {
  CircumscribingMind mind(
      "fof(pair, axiom, ! [X] : (in(X) => link(X, f(X)))).\n"
      "fof(sum, axiom, ! [X] : (in(X) => link(X, $sum(X, 1)))).\n"
      "fof(same, axiom, ! [X, Y] : ((in(X) & in(Y)) => link(X, Y))).\n");
  mind.Input("in", 1);
  mind.Goal("link(X, Y)");
  mind.Parameter("mode", "exact");
  mind.Load();
  mind.Latch(0, {"in(1)", "in(5)"});
  mind.Decide();
  EXPECT_EQ(ToText(*mind.reasoner.WhyNot(mind.Atom("link(X, g(X))"))),
            "nothing concludes link(X0, g(X0)):\n"
            "  'sum' has 0 of 1 premises and lacks in(X)\n"
            "  'same' has 1 of 2 premises and lacks in(g(1))\n");
  EXPECT_EQ(ToText(*mind.reasoner.WhyNot(mind.Atom("link(f(X), X)"))),
            "nothing concludes link(f(X0), X0):\n"
            "  'sum' has 0 of 1 premises and lacks in(f(X1))\n"
            "  'same' has 0 of 2 premises and lacks in(f(Y))\n");
  // Goals want their first instance only; what else holds is said to.
  ASSERT_EQ(mind.decision.conclusions.size(), 1U);
  EXPECT_TRUE(mind.reasoner.WhyNot(mind.Atom("link(5, 1)"))->holds);
  EXPECT_TRUE(mind.reasoner.WhyNot(mind.Atom("link(5, 6)"))->holds);
}

TEST(SpentExplanationTest, NoBudgetMakesAnAnswerOfWhatItCutShort) {
  for (const char* entailment : {"cautious", "brave"}) {
    CircumscribingMind mind(
        "fof(step, axiom, ! [X, Y] : (edge(X, Y) => path(X, Y))).\n"
        "fof(far, axiom, ! [X, Y, Z] : ((edge(X, Y) & path(Y, Z)) => path(X, Z))).\n");
    mind.Input("edge", 2);
    mind.Goal("path(X, c)", sdk::Goal::Answers::kAll);
    mind.Goal("path(d, X)", sdk::Goal::Answers::kAll);
    mind.Parameter("mode", "exact");
    mind.Parameter("entailment", entailment);
    mind.Parameter("cache_decisions", "false");
    mind.Load();
    mind.Latch(0, {"edge(a, b)", "edge(b, c)", "edge(b, d)", "edge(d, a)"});
    bool is_decided = false;
    for (mind.budget.inferences = 1; mind.budget.inferences < 1000 && !is_decided;
         ++mind.budget.inferences) {
      is_decided = mind.Decide().status != sdk::Status::kUnknown;
      if (is_decided) continue;
      EXPECT_EQ(mind.decision.limit, sdk::Limit::kInferences);
      const auto explanation = mind.reasoner.WhyNot(mind.Atom("path(d, d)"));
      EXPECT_TRUE(!explanation || explanation->holds) << mind.budget.inferences;
    }
    ASSERT_TRUE(is_decided);
    EXPECT_EQ(mind.decision.status, sdk::Status::kProved);
    EXPECT_EQ(mind.decision.conclusions.size(), 7U) << entailment;
  }
}

TEST(SpentExplanationTest, NothingIsExplainedWhereTheBudgetRanOut) {
  CircumscribingMind mind("fof(some, axiom, ! [M] : (move(M) => (push(left) | push(right)))).\n");
  mind.Input("move", 1);
  mind.Minimize("push", 1);
  mind.Parameter("entailment", "brave");
  mind.Goal("push(left)");
  mind.Parameter("mode", "exact");
  mind.Load();
  const logic::Atom pattern = mind.body.goals[0].pattern;
  mind.Latch(0, {"move(on)"});
  mind.budget.inferences = 1;
  ASSERT_EQ(mind.Decide().limit, sdk::Limit::kInferences);
  EXPECT_FALSE(mind.reasoner.WhyNot(pattern).has_value());
  mind.budget.inferences = 1000;
  mind.Decide();
  EXPECT_TRUE(mind.reasoner.WhyNot(pattern).has_value());
  mind.Latch(0, {"move(on)", "move(off)"});
  mind.budget.inferences = 1;
  ASSERT_EQ(mind.Decide().limit, sdk::Limit::kInferences);
  EXPECT_FALSE(mind.reasoner.WhyNot(pattern).has_value());
}

TEST(BoundedExplanationTest, ReasonsAreTheProvers) {
  CircumscribingMind mind(pttp::kReflex);
  mind.Goal("fwd(V)");
  mind.Input("speed", 1);
  for (const char* name : {"object", "gap"}) mind.Input(name, 1);
  mind.Input("distance", 2);
  mind.Input("bumper", 0);
  mind.Minimize("halt_robot", 0);
  mind.Parameter("mode", "bounded");
  mind.Load();
  mind.Latch(0, {"speed(0.3)"});
  EXPECT_FALSE(mind.reasoner.ExplainAssumption(0).has_value());
  mind.Decide();
  const auto explanation = mind.reasoner.ExplainAssumption(0);
  ASSERT_TRUE(explanation.has_value());
  EXPECT_THAT(ToText(*explanation), ::testing::HasSubstr("'touched' has 0 of 1 premises"));
  EXPECT_TRUE(mind.reasoner.WhyNot(mind.Atom("fwd(V)"))->holds);
}

}  // namespace
}  // namespace latchwork::circumscription
