// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "core/process/spawn.h"
#include "reasoners/swipl/swipl_reasoner.h"
#include "tests/reasoners/pttp/agent_mind.h"

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
using Mind = pttp::MindOf<SwiplReasoner>;

class SwiplTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (process::FindProgram("swipl").empty()) GTEST_SKIP() << "swi-prolog-nox is not installed";
  }
};

TEST_F(SwiplTest, HornRules_AllAnswers) {
  Mind mind(R"(
    fof(step, axiom, ![X,Y] : (edge(X,Y) => path(X,Y))).
    fof(far, axiom, ![X,Y,Z] : ((edge(X,Y) & path(Y,Z)) => path(X,Z))).
  )");
  mind.Input("edge", 2);
  mind.Goal("path(a,X)", Answers::kAll);
  mind.Load();
  mind.Latch(0, {"edge(a,b)", "edge(b,c)", "edge(c,a)"});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), UnorderedElementsAre("path(a, b)", "path(a, c)", "path(a, a)"));
  mind.Latch(0, {"edge(b,c)"});
  EXPECT_EQ(mind.Decide().status, Status::kRefuted);
}

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

TEST_F(SwiplTest, Cancellation_IsHeard) {
  Mind mind(kCounting);
  mind.Goal("n(c)");
  mind.Load();
  const std::atomic<bool> cancelled = true;
  mind.budget.cancelled = &cancelled;
  EXPECT_EQ(mind.Decide().limit, Limit::kCancelled);
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

TEST_F(SwiplTest, TellAndRetract) {
  Mind mind("fof(a, axiom, p => q).");
  mind.Input("p", 0);
  mind.Goal("q");
  mind.Load();
  mind.Latch(0, {});
  EXPECT_EQ(mind.Decide().status, Status::kRefuted);
  EXPECT_THAT(mind.reasoner.Tell("fof(b, axiom, q)."), IsEmpty());
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.reasoner.Retract("b"), IsEmpty());
  EXPECT_EQ(mind.Decide().status, Status::kRefuted);
}

/// total(Sum, Least): over the provable sizes that are at least as large.
class Total final : public sdk::Attachment {
 public:
  explicit Total(logic::SymbolTable& symbols) : size_(symbols.Intern("size")) {}
  const Signature& signature() const override {
    static const Signature signature{"total",
                                     {{{"least", sdk::ArgumentType::kInteger, ""}, Mode::kIn},
                                      {{"sum", sdk::ArgumentType::kInteger, ""}, Mode::kOut}},
                                     ""};
    return signature;
  }
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override {
    if (inputs[0].integer() < 0) throw std::runtime_error("negative");
    struct Sink final : sdk::AnswerSink {
      void Answer(std::span<const logic::Term> terms) override {
        if (terms.size() == 2 && terms[1].integer() >= least) sum += terms[1].integer();
      }
      std::int64_t least = 0;
      std::int64_t sum = 0;
    } sink;
    sink.least = inputs[0].integer();
    const std::vector<logic::Literal> query = {
        {true, {size_, {logic::Term::Var(0), logic::Term::Var(1)}}}};
    context.ForEachProvable(query, 2, sink);
    const std::array<logic::Term, 1> answer = {logic::Term::Integer(sink.sum)};
    outputs.Answer(answer);
  }

 private:
  logic::Symbol size_;
};

void PrepareTotal(Mind& mind) {
  mind.body.attachments.push_back(std::make_shared<Total>(mind.symbols));
  mind.Input("box", 2);
  mind.Input("least", 1);
  mind.Minimize("bad", 1);
  mind.Goal("sum(S)");
  mind.Load();
}
constexpr std::string_view kBoxes = R"(
  fof(size, axiom, ![B,N] : ((box(B,N) & ~ bad(B)) => size(B,N))).
  fof(sum, axiom, ![L,S] : ((total(L,S) & least(L)) => sum(S))).
)";

TEST_F(SwiplTest, AttachmentsAskProlog) {
  Mind mind(kBoxes);
  PrepareTotal(mind);
  mind.Latch(0, {"box(a,1)", "box(b,20)", "box(c,300)", "least(2)"});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("sum(320)"));
  EXPECT_EQ(mind.decision.statistics.attachment_calls, 1U);
  EXPECT_EQ(mind.decision.conclusions[0].assumptions.size(), 3U);
}

/// twice(X, Y).
class Twice final : public sdk::Attachment {
 public:
  const Signature& signature() const override {
    static const Signature signature{"twice",
                                     {{{"of", sdk::ArgumentType::kInteger, ""}, Mode::kIn},
                                      {{"is", sdk::ArgumentType::kInteger, ""}, Mode::kOut}},
                                     ""};
    return signature;
  }
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& /*context*/,
            sdk::AnswerSink& outputs) override {
    const std::array<logic::Term, 1> answer = {logic::Term::Integer(2 * inputs[0].integer())};
    outputs.Answer(answer);
  }
};

TEST_F(SwiplTest, LimitWithinACall_LeavesNoReplyForTheNext) {
  // Some of these limits fall between a call and the reading of its reply.
  for (int limit = 1; limit <= 20; ++limit) {
    Mind mind(R"(
      fof(never, axiom, ![X,Y] : ~ (in(X) & twice(X, Y) & bad(Y))).
      fof(out, axiom, ![X,Y] : ((from(X) & twice(X, Y)) => out(Y))).
    )");
    mind.body.attachments.push_back(std::make_shared<Twice>());
    mind.Input("in", 1);
    mind.Input("bad", 1);
    mind.Input("from", 1);
    mind.Goal("out(Y)", Answers::kAll);
    mind.Parameter("consistency_inferences", std::to_string(limit));
    mind.Load();
    mind.Latch(0, {"in(1)", "in(2)", "in(3)", "from(2)", "from(40)"});
    EXPECT_EQ(mind.Decide().status, Status::kProved);
    EXPECT_THAT(mind.Conclusions(), UnorderedElementsAre("out(4)", "out(80)")) << limit;
  }
}

TEST_F(SwiplTest, AttachmentThatThrows_LeavesTheReasonerWhole) {
  Mind mind(kBoxes);
  PrepareTotal(mind);
  mind.Latch(0, {"least(-1)"});
  EXPECT_THROW(mind.Decide(), std::runtime_error);
  mind.Latch(0, {"box(a,5)", "least(2)"});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("sum(5)"));
}

TEST(SwiplProgramTest, Absent_SaysWhatToInstall) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  Mind mind("fof(a, axiom, p).");
  mind.Goal("p");
  const auto diagnostics = mind.TryLoad();
  setenv("PATH", path.c_str(), 1);
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_THAT(diagnostics[0].hint, HasSubstr("swi-prolog-nox"));
}

}  // namespace
}  // namespace latchwork::swipl
