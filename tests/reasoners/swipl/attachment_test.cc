// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include "reasoners/pttp/pttp_reasoner.h"
#include "tests/reasoners/swipl/setting.h"

namespace latchwork::swipl {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;
using Answers = sdk::Goal::Answers;
using sdk::Status;

class SwiplAttachmentTest : public OutsideProgramTest<Setting> {};

/// total(Least, Sum): over the provable sizes that are at least as large.
class Total final : public sdk::Attachment {
 public:
  explicit Total(logic::SymbolTable& symbols, std::string_view size = "size",
                 std::string_view name = "total")
      : signature_{std::string(name),
                   {{{"least", sdk::ArgumentType::kInteger, ""}, Mode::kIn},
                    {{"sum", sdk::ArgumentType::kInteger, ""}, Mode::kOut}},
                   ""},
        size_(symbols.Intern(size)) {}
  const Signature& signature() const override { return signature_; }
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
  Signature signature_;
  logic::Symbol size_;
};

template <typename Reasoner>
void PrepareTotal(pttp::MindOf<Reasoner>& mind) {
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

TEST_F(SwiplAttachmentTest, AttachmentsAskProlog) {
  Mind mind(kBoxes);
  PrepareTotal(mind);
  mind.Latch(0, {"box(a,1)", "box(b,20)", "box(c,300)", "least(2)"});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("sum(320)"));
  EXPECT_EQ(mind.decision.statistics.attachment_calls, 1U);
  EXPECT_EQ(mind.decision.conclusions[0].assumptions.size(), 3U);
}

/// What was decided: status, conclusions, and the assumptions that each rests on, in order.
template <typename Reasoner>
std::string Decided(pttp::MindOf<Reasoner>& mind) {
  const sdk::Decision& decision = mind.Decide();
  std::string text(Name(decision.status));
  for (const auto& conclusion : decision.conclusions) {
    text += "; " + ToString(conclusion.fact);
    std::set<std::string> assumptions;
    for (const std::size_t index : conclusion.assumptions) {
      assumptions.insert(" ~" + ToString(decision.assumptions.at(index).atom));
    }
    for (const std::string& assumption : assumptions) text += assumption;
  }
  return text;
}

/// Swipl must decide as the prover does.
template <typename Prepare>
void ExpectDecidedAlike(std::string_view theory, const Prepare& prepare,
                        std::string_view expected) {
  pttp::AgentMind prover("of_prover", theory);
  prepare(prover);
  EXPECT_EQ(Decided(prover), expected) << "the prover";
  Mind mind("of_swipl", theory);
  prepare(mind);
  EXPECT_EQ(Decided(mind), expected);
}

constexpr std::string_view kFragile = R"(
  fof(size, axiom, ![B,N] : ((box(B,N) & ~ bad(B)) => size(B,N))).
  fof(sum, axiom, ![L,S] : ((total(L,S) & least(L)) => sum(S))).
  fof(never, axiom, ![L,S] : ~ (least(L) & total(L,S) & broken(S))).
)";

TEST_F(SwiplAttachmentTest, AskedWithinADenial_DefaultsAreMade) {
  const auto prepare = [](std::string_view broken) {
    return [broken](auto& mind) {
      mind.Input("broken", 1);
      PrepareTotal(mind);
      mind.Latch(0, {"box(a,1)", "box(b,20)", "least(2)", std::string(broken)});
    };
  };
  ExpectDecidedAlike(kFragile, prepare("broken(0)"), "proved; sum(20) ~bad(a) ~bad(b)");
  ExpectDecidedAlike(kFragile, prepare("broken(20)"), "inconsistent");
}

TEST_F(SwiplAttachmentTest, LimitWhileADefaultIsMadeForADenial_CountsItOnce) {
  for (int limit = 10; limit <= 40; limit += 3) {
    Mind mind(kFragile);
    mind.Input("broken", 1);
    mind.Parameter("consistency_inferences", std::to_string(limit));
    PrepareTotal(mind);
    mind.Latch(0, {"box(a,1)", "box(b,20)", "least(2)", "broken(0)"});
    EXPECT_EQ(Decided(mind), "proved; sum(20) ~bad(a) ~bad(b)") << limit;
    EXPECT_EQ(mind.decision.assumptions.size(), 2U) << limit;
  }
}

TEST_F(SwiplAttachmentTest, AskedBelowAnother_BothKeepTheirAssumptions) {
  const auto prepare = [](auto& mind) {
    mind.body.attachments.push_back(std::make_shared<Total>(mind.symbols, "part", "inside"));
    mind.Input("piece", 2);
    mind.Minimize("lost", 1);
    PrepareTotal(mind);
    mind.Latch(0, {"box(a,1)", "piece(p,30)", "least(0)"});
  };
  ExpectDecidedAlike(R"(
    fof(part, axiom, ![B,N] : ((piece(B,N) & ~ lost(B)) => part(B,N))).
    fof(size, axiom, ![B,N] : ((box(B,N) & ~ bad(B)) => size(B,N))).
    fof(crate, axiom, ![N] : (inside(0,N) => size(crate,N))).
    fof(sum, axiom, ![L,S] : ((total(L,S) & least(L)) => sum(S))).
  )",
                     prepare, "proved; sum(31) ~bad(a) ~lost(p)");
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

TEST_F(SwiplAttachmentTest, LimitWithinACall_LeavesNoReplyForTheNext) {
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

TEST_F(SwiplAttachmentTest, AttachmentThatThrows_LeavesTheReasonerWhole) {
  Mind mind(kBoxes);
  PrepareTotal(mind);
  mind.Latch(0, {"least(-1)"});
  EXPECT_THROW(mind.Decide(), std::runtime_error);
  mind.Latch(0, {"box(a,5)", "least(2)"});
  EXPECT_EQ(mind.Decide().status, Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("sum(5)"));
}

}  // namespace
}  // namespace latchwork::swipl
