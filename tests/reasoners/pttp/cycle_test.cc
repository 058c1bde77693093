// SPDX-License-Identifier: BSD-3-Clause
// What stands from cycle to cycle, and what does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::string_view kTwoGoals = R"(
fof(warm, axiom, ![T] : ((heat(T) & $greater(T, 20)) => warm(T))).
fof(bright, axiom, ![L] : ((light(L) & ~ covered) => bright(L))).
fof(covered, axiom, ![X] : (lid(X) => covered)).
)";

void LoadTwoGoals(AgentMind& mind) {
  for (const char* name : {"heat", "light", "lid"}) mind.Input(name, 1);
  mind.Minimize("covered", 0);
  mind.Goal("warm(T)");
  mind.Goal("bright(L)");
  mind.Load();
  mind.Latch(0, {"heat(25)"});
  mind.Latch(1, {"light(7)"});
  mind.Latch(2, {});
}

TEST(CycleTest, GoalStandsWhileNothingItSeesChanges) {
  AgentMind mind(kTwoGoals);
  LoadTwoGoals(mind);
  const auto all = mind.Decide().statistics.inferences;
  mind.Latch(0, {"heat(30)"});
  const auto one = mind.Decide().statistics.inferences;
  EXPECT_GT(one, 0U);
  EXPECT_LT(one, all);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("warm(30)", "bright(7)"));
  ASSERT_EQ(mind.decision.assumptions.size(), 1U);
  EXPECT_EQ(ToString(mind.decision.assumptions[0].atom), "covered");
  EXPECT_THAT(mind.decision.conclusions[1].assumptions, ElementsAre(0U));
}

TEST(CycleTest, NewBatchOfTheSameFactsChangesNothing) {
  AgentMind mind(kTwoGoals);
  LoadTwoGoals(mind);
  mind.Decide();
  mind.Latch(0, {"heat(25)"});
  EXPECT_EQ(mind.Decide().statistics.inferences, 0U);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("warm(25)", "bright(7)"));
}

TEST(CycleTest, DefaultIsRetractedThroughItsClosing) {
  AgentMind mind(kTwoGoals);
  LoadTwoGoals(mind);
  mind.Decide();
  mind.Latch(2, {"lid(shut)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("warm(25)"));
  mind.Latch(2, {});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("warm(25)", "bright(7)"));
}

TEST(CycleTest, OtherBudgetDecidesAnew) {
  AgentMind mind(kTwoGoals);
  LoadTwoGoals(mind);
  mind.Decide();
  mind.budget.depth = 7;
  EXPECT_GT(mind.Decide().statistics.inferences, 0U);
}

TEST(CycleTest, RowsMayBecomeFewerAndOther) {
  AgentMind mind("cnf(r, axiom, seen(X, Y) | ~ pair(X, Y)).");
  mind.Input("pair", 2);
  mind.Goal("seen(X, Y)", sdk::Goal::Answers::kAll);
  mind.Load();
  const std::vector<std::vector<std::string>> batches = {
      {"pair(1, 2.5)", "pair(a, f(1))", "pair(2, f(g(b)))"},
      {"pair(1, 2.5)", "pair(a, f(2))"},
      {"pair(b, 7)", "pair(1.5, a)", "pair(2, f(g(c)))", "pair(f(a), 3)"},
      {},
      {"pair(1, 2.5)"}};
  for (const auto& batch : batches) {
    mind.Latch(0, batch);
    mind.Decide();
    std::vector<std::string> expected;
    for (const auto& fact : batch) expected.push_back("seen" + fact.substr(4));
    EXPECT_EQ(mind.Conclusions(), expected);
  }
}

TEST(CycleTest, ToldAndRetractedClausesCountAtOnce) {
  AgentMind mind(kTwoGoals);
  LoadTwoGoals(mind);
  mind.Decide();
  EXPECT_THAT(mind.reasoner.Tell("fof(lid_too, axiom, ![T] : ((heat(T) & $greater(T, 24)) => "
                                 "covered))."),
              IsEmpty());
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("warm(25)"));
  mind.Latch(0, {"heat(22)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("warm(22)", "bright(7)"));
  mind.Latch(0, {"heat(25)"});
  EXPECT_THAT(mind.reasoner.Retract("lid_too"), IsEmpty());
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("warm(25)", "bright(7)"));
}

TEST(CycleTest, ContradictionComesAndGoesWithTheLatches) {
  AgentMind mind(std::string(kTwoGoals) +
                 "fof(law, axiom, ![T, L] : ~ (heat(T) & light(L) & $less(T, L))).");
  LoadTwoGoals(mind);
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  mind.Latch(1, {"light(90)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kInconsistent);
  EXPECT_THAT(mind.decision.message, HasSubstr("light(90)"));
  EXPECT_THAT(mind.Conclusions(), IsEmpty());
  mind.Latch(1, {"light(7)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
}

/// Cancels when it is called for a certain time and counts the calls after that.
class Trigger final : public sdk::Attachment {
 public:
  explicit Trigger(std::atomic<bool>& cancelled) : cancelled_(cancelled) {
    signature_.predicate = "tick";
    signature_.arguments = {{{"n", sdk::ArgumentType::kAny, ""}, Mode::kIn}};
  }
  const Signature& signature() const override { return signature_; }
  void Call(std::span<const logic::Term> /*inputs*/, sdk::AttachmentContext& /*context*/,
            sdk::AnswerSink& outputs) override {
    if (++calls_ == 1000) cancelled_ = true;
    if (calls_ > 1000) ++late;
    outputs.Answer({});
  }
  int late = 0;

 private:
  std::atomic<bool>& cancelled_;
  Signature signature_;
  int calls_ = 0;
};

TEST(CycleTest, CancellationIsNoticedWithinAFewSteps) {
  for (const char* tables : {"true", "false"}) {
    AgentMind mind(std::string("cancel_") + tables,
                   "fof(all, axiom, ![X, Y] : ((item(X) & item(Y) & tick(pair(X, Y))) => "
                   "seen(X, Y))).");
    std::atomic<bool> cancelled{false};
    const auto trigger = std::make_shared<Trigger>(cancelled);
    mind.body.attachments.push_back(trigger);
    mind.Input("item", 1);
    mind.Goal("seen(X, Y)", sdk::Goal::Answers::kAll);
    mind.Parameter("tables", tables);
    mind.Load();
    std::vector<std::string> items;
    for (int i = 0; i < 200; ++i) items.push_back("item(" + std::to_string(i) + ")");
    mind.Latch(0, items);
    mind.budget.cancelled = &cancelled;
    EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
    EXPECT_EQ(mind.decision.limit, sdk::Limit::kCancelled);
    EXPECT_LT(trigger->late, 256);
  }
}

}  // namespace
}  // namespace latchwork::pttp
