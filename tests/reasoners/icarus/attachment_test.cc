// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tests/reasoners/icarus/program_mind.h"
#include "tests/reasoners/icarus/test_attachments.h"

namespace latchwork::icarus::testing {
namespace {

using logic::Literal;
using logic::Term;
using sdk::ArgumentType;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::string_view kHalve = R"((top (Top))
(Top () :requires ((given ?n) (bind (?half ?rest) {halves ?n})) :means ((Say ?half ?rest)))
(Say (?a ?b) :action ({say ?a ?b})))";

TEST(IcarusAttachmentTest, AnswersAreTakenApart) {
  ProgramMind mind(kHalve);
  mind.Input("given", {ArgumentType::kAny});
  mind.Output("say", {ArgumentType::kInteger, ArgumentType::kInteger});
  mind.attachments = {std::make_shared<Halves>()};
  mind.Load();
  mind.Latch(0, {"given(7)"});
  EXPECT_THAT(mind.Decide(), ElementsAre("say(3, 1)"));
  EXPECT_EQ(mind.decision.statistics.attachment_calls, 1U);
  mind.Latch(0, {"given(-1)"});
  EXPECT_THAT(mind.Decide(), IsEmpty());
  EXPECT_EQ(mind.decision.message, "");
  mind.Latch(0, {"given(7.5)"});
  EXPECT_THAT(mind.Decide(), IsEmpty());
  EXPECT_THAT(mind.decision.message,
              HasSubstr(":2:51: {halves}: argument 1, 7.5, is not an integer (in Top)"));
  mind.Latch(0, {"given(13)"});
  mind.Decide();
  EXPECT_THAT(mind.decision.message, HasSubstr("{halves}: thirteen"));
}

/// `sum` adds what `query`, over two variables, finds.
void AddTotal(ProgramMind& mind, const std::vector<Literal>& query) {
  mind.Input("price", {ArgumentType::kSymbol, ArgumentType::kInteger});
  mind.Output("pay", {ArgumentType::kInteger});
  mind.attachments = {std::make_shared<Total>("sum", query, 2)};
}

constexpr std::string_view kPay = R"((top (Pay))
(Pay () :requires ((bind ?s {sum})) :means ((PayIt ?s)))
(PayIt (?s) :action ({pay ?s}))
(Dear (?x ?p) :objective ((price ?x ?p) {> ?p 5}))  ; allow I018
)";

TEST(IcarusAttachmentTest, AsksMemory) {
  ProgramMind mind(kPay);
  const Term x = Term::Var(0);
  const Term p = Term::Var(1);
  AddTotal(mind, {{true, {mind.symbols.Intern("price"), {x, p}}}});
  mind.Load();
  mind.Latch(0, {"price(a, 1)", "price(b, 10)", "price(c, 100)"});
  EXPECT_THAT(mind.Decide(), ElementsAre("pay(111)"));
  mind.Latch(0, {"price(a, 1)", "price(c, 100)"});
  EXPECT_THAT(mind.Decide(), ElementsAre("pay(101)"));
}

TEST(IcarusAttachmentTest, AsksSkillsAndNegations) {
  ProgramMind mind(kPay);
  const Term x = Term::Var(0);
  const Term p = Term::Var(1);
  const logic::Symbol price = mind.symbols.Intern("price");
  AddTotal(mind, {{true, {mind.symbols.Intern("dear"), {x, p}}},
                  {false, {price, {x, Term::Integer(10)}}}});
  mind.Load();
  mind.Latch(0, {"price(a, 1)", "price(b, 10)", "price(c, 100)"});
  EXPECT_THAT(mind.Decide(), ElementsAre("pay(100)"));
}

TEST(IcarusAttachmentTest, EachInstanceOnce) {
  ProgramMind mind(R"((top (Pay))
(Pay () :requires ((bind ?s {sum})) :means ((PayIt ?s)))
(Offered (?p) :objective ((price ? ?p)))  ; allow I018
(PayIt (?s) :action ({pay ?s})))");
  mind.Input("price", {ArgumentType::kSymbol, ArgumentType::kInteger});
  mind.Output("pay", {ArgumentType::kInteger});
  const Literal offered{true, {mind.symbols.Intern("offered"), {Term::Var(0)}}};
  mind.attachments = {std::make_shared<Total>("sum", std::vector<Literal>{offered, offered}, 1)};
  mind.Load();
  mind.Latch(0, {"price(a, 3)", "price(b, 3)", "price(c, 4)"});
  EXPECT_THAT(mind.Decide(), ElementsAre("pay(7)"));
}

TEST(IcarusAttachmentTest, AskingWithoutEndIsAFault) {
  ProgramMind mind(R"((top (Pay))
(Pay () :requires ((Total ?s)) :means ((PayIt ?s)))
(Total (?s) :objective ((bind ?s {sum})))
(PayIt (?s) :action ({pay ?s})))");
  AddTotal(mind, {{true, {mind.symbols.Intern("total"), {Term::Var(1)}}}});
  mind.Load();
  EXPECT_THAT(mind.Decide(), ElementsAre("pay(0)"));
  EXPECT_THAT(mind.decision.message, HasSubstr("host functions ask each other for ever"));
}

TEST(IcarusAttachmentTest, WhatIsAskedCountsAgainstTheBudget) {
  ProgramMind mind(R"((top (Pay))
(Pay () :requires ((bind ?s {sum})) :means ((PayIt ?s)))
(Pair (?x ?p) :objective ((price ? ?) (price ? ?) (price ?x ?p) {> ?p 5}))  ; allow I018
(PayIt (?s) :action ({pay ?s})))");
  AddTotal(mind, {{true, {mind.symbols.Intern("pair"), {Term::Var(0), Term::Var(1)}}}});
  mind.Load();
  std::vector<std::string> prices;
  for (int i = 0; i < 50; ++i) prices.push_back("price(x" + std::to_string(i) + ", 7)");
  mind.Latch(0, prices);
  mind.budget.inferences = 1000;
  mind.Decide();
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kInferences);
  EXPECT_EQ(mind.decision.statistics.inferences, 1000U);
}

}  // namespace
}  // namespace latchwork::icarus::testing
