// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Mode = sdk::Attachment::Mode;

/// total(S): the sum of D over every provable distance(O, D).
class Total final : public sdk::Attachment, private sdk::AnswerSink {
 public:
  explicit Total(logic::SymbolTable& symbols) {
    using logic::Term;
    query_.push_back({true, logic::Atom(symbols.Intern("distance"), {Term::Var(0), Term::Var(1)})});
    signature_.predicate = "total";
    signature_.arguments = {{{"sum", sdk::ArgumentType::kReal, "m"}, Mode::kOut}};
  }
  const Signature& signature() const override { return signature_; }
  void Call(std::span<const logic::Term> /*inputs*/, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override {
    sum_ = 0;
    context.ForEachProvable(query_, 2, *this);
    const logic::Term result = logic::Term::Real(sum_);
    outputs.Answer({&result, 1});
  }

 private:
  void Answer(std::span<const logic::Term> terms) override { sum_ += terms.back().number(); }

  Signature signature_;
  std::vector<logic::Literal> query_;
  double sum_ = 0;
};

/// root(X, R): both square roots of a number, NaN included.
class Root final : public sdk::Attachment {
 public:
  Root() {
    signature_.predicate = "root";
    signature_.arguments = {{{"x", sdk::ArgumentType::kReal, ""}, Mode::kIn},
                            {{"r", sdk::ArgumentType::kReal, ""}, Mode::kOut}};
  }
  const Signature& signature() const override { return signature_; }
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& /*context*/,
            sdk::AnswerSink& outputs) override {
    const double root = inputs[0].number() < 0 ? std::numeric_limits<double>::quiet_NaN() : 2.0;
    for (const double value : {root, -root}) {
      const logic::Term result = logic::Term::Real(value);
      outputs.Answer({&result, 1});
    }
  }

 private:
  Signature signature_;
};

TEST(AttachmentTest, AsksForEveryProvableInstanceOnce) {
  AgentMind mind(R"(
fof(seen, axiom, ![N, D] : (reading(N, D) => distance(sonar_obj(N), D))).
fof(goal, axiom, ![S] : (total(S) => push(S))).
)");
  mind.Input("reading", 2);
  mind.Input("distance", 2);
  mind.body.attachments.push_back(std::make_shared<Total>(mind.symbols));
  mind.Goal("push(S)");
  mind.Load();
  mind.Latch(0, {"reading(0, 1.5)", "reading(1, 2.0)", "distance(virtual, 4.0)",
                 "distance(virtual, 4.0)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("push(7.5)"));
}

TEST(AttachmentTest, ResultsAreKeptForACycle) {
  for (const bool cache : {true, false}) {
    AgentMind mind("fof(g, axiom, ![S, N] : ((wanted(N) & total(S)) => push(N, S))).");
    mind.Input("wanted", 1);
    mind.Input("distance", 2);
    mind.body.attachments.push_back(std::make_shared<Total>(mind.symbols));
    mind.Goal("push(N, S)", sdk::Goal::Answers::kAll);
    mind.Parameter("cache_attachments", cache ? "true" : "false");
    mind.Load();
    mind.Latch(0, {"wanted(1)", "wanted(2)", "wanted(3)", "distance(a, 1.0)"});
    mind.Decide();
    EXPECT_EQ(mind.decision.conclusions.size(), 3U);
    EXPECT_EQ(mind.decision.statistics.attachment_calls, cache ? 1U : 3U);
  }
}

TEST(AttachmentTest, EnumeratesItsOutputs) {
  AgentMind mind("fof(g, axiom, ![X, R] : ((root(X, R) & value(X)) => answer(R))).");
  mind.Input("value", 1);
  mind.body.attachments.push_back(std::make_shared<Root>());
  mind.Goal("answer(R)", sdk::Goal::Answers::kAll);
  mind.Load();
  mind.Latch(0, {"value(4.0)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("answer(2.0)", "answer(-2.0)"));
}

TEST(AttachmentTest, NumberThatIsNotFiniteIsAFault) {
  AgentMind mind("fof(g, axiom, ![X, R] : ((root(X, R) & value(X)) => answer(R))).");
  mind.Input("value", 1);
  mind.body.attachments.push_back(std::make_shared<Root>());
  mind.Goal("answer(R)");
  mind.Load();
  mind.Latch(0, {"value(-4.0)"});
  EXPECT_THROW(mind.Decide(), std::runtime_error);
  mind.Latch(0, {"value(4.0)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
}

TEST(AttachmentTest, OtherArityIsReported) {
  AgentMind mind("fof(g, axiom, ![X] : (root(X) => answer(X))).");
  mind.body.attachments.push_back(std::make_shared<Root>());
  mind.Goal("answer(R)");
  const auto diagnostics = mind.TryLoad();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_THAT(diagnostics[0].message, HasSubstr("root/2"));
}

}  // namespace
}  // namespace latchwork::pttp
