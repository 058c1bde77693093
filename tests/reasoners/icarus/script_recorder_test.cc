// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/tools/script_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/reasoners/icarus/program_mind.h"
#include "tests/reasoners/icarus/script_run.h"
#include "tests/reasoners/icarus/test_attachments.h"

namespace latchwork::icarus {
namespace {

using Facts = std::vector<FactText>;

std::string TextOf(const FactText& fact) {
  std::string text = "(";
  for (const std::string& item : fact) text += (text.size() == 1 ? "" : " ") + item;
  return text + ')';
}

/// Some of the facts (a I), (a I J) and (b I), each once, in any order.
Facts RandomFacts(std::mt19937& random) {
  Facts facts;
  for (const char* const i : {"0", "1", "2"}) {
    facts.push_back({"a", i});
    facts.push_back({"b", i});
    for (const char* const j : {"0", "1"}) facts.push_back({"a", i, j});
  }
  std::shuffle(facts.begin(), facts.end(), random);
  facts.resize(random() % (facts.size() + 1));
  return facts;
}

/// A step further: some facts of the same head and length give way to others, at their places.
Facts Moved(Facts facts, std::mt19937& random) {
  for (FactText& fact : facts) {
    FactText other = fact;
    other.back() = std::to_string(random() % 5);
    if (std::find(facts.begin(), facts.end(), other) == facts.end()) fact = other;
  }
  return facts;
}

/// What memory holds after a script of one cycle of `items`, when it held `before`.
std::vector<std::string> MemoryAfter(const Facts& before, const std::vector<std::string>& items) {
  std::string script = "(top (S))\n(cycle";
  for (const FactText& fact : before) script += " (store " + TextOf(fact) + ')';
  script += ")\n(cycle";
  for (const std::string& item : items) script += ' ' + item;
  testing::ScriptRun run("(S () :objective ((x)))", script + ")\n");
  std::vector<std::string> facts;
  const FactStore& memory = run.interpreter().memory();
  for (const auto* fact = memory.First(); fact != nullptr; fact = fact->next) {
    if (fact->died == 0) facts.push_back(ToString(fact->value, run.names()));
  }
  return facts;
}

/// The facts of each head and length.
std::map<std::pair<std::string, std::size_t>, Facts> ByHead(const Facts& facts) {
  std::map<std::pair<std::string, std::size_t>, Facts> by_head;
  for (const FactText& fact : facts) by_head[{fact[0], fact.size()}].push_back(fact);
  return by_head;
}

TEST(ScriptRecorderTest, MemoryChanges_LeadToWhatIsThereAfterwards) {
  std::mt19937 random(7);
  for (int i = 0; i < 400; ++i) {
    const Facts before = RandomFacts(random);
    const Facts after = i % 2 == 0 ? RandomFacts(random) : Moved(before, random);
    std::vector<std::string> texts;
    for (const FactText& fact : after) texts.push_back(TextOf(fact));
    EXPECT_EQ(MemoryAfter(before, MemoryChanges(before, after, FactOrder::kOfAll)), texts);

    Facts reached;
    for (const std::string& text :
         MemoryAfter(before, MemoryChanges(before, after, FactOrder::kOfHead))) {
      const auto same = std::find(texts.begin(), texts.end(), text);
      ASSERT_NE(same, texts.end()) << text;
      reached.push_back(after[static_cast<std::size_t>(same - texts.begin())]);
    }
    EXPECT_EQ(ByHead(reached), ByHead(after));
  }
}

TEST(ScriptRecorderTest, MemoryChanges_AreShort) {
  EXPECT_EQ(MemoryChanges({{"pose", "1", "2"}}, {{"pose", "1", "3"}}, FactOrder::kOfHead),
            std::vector<std::string>{"(update (pose 1 ?) (pose 1 3))"});
  // Here the pattern would fit another fact, too.
  EXPECT_EQ(
      MemoryChanges({{"at", "1"}, {"at", "2"}}, {{"at", "3"}, {"at", "2"}}, FactOrder::kOfHead),
      std::vector<std::string>{"(update (at 1) (at 3))"});
  // Facts of other heads do not matter, unless the order of all does.
  const Facts before = {{"a", "1"}, {"b", "1"}};
  const Facts after = {{"a", "1"}, {"a", "2"}, {"b", "1"}};
  EXPECT_EQ(MemoryChanges(before, after, FactOrder::kOfHead),
            std::vector<std::string>{"(store (a 2))"});
  EXPECT_EQ(MemoryChanges(before, after, FactOrder::kOfAll).size(), 3U);
}

TEST(ScriptRecorderTest, OrderOfAllMatters_WhereAMatchHasAnyHead) {
  const auto order = [](const char* text) {
    return OrderSeenBy(ReadProgram(text, "p.icarus").program);
  };
  EXPECT_EQ(order("(S () :objective ((a ?x) (*not* (b ?x))))"), FactOrder::kOfHead);
  EXPECT_EQ(order("(S () :objective ((a ?x) (*not* (?x b))))"), FactOrder::kOfAll);
  EXPECT_EQ(order("(top (S))\n(S ())\n(never (?any 1))"), FactOrder::kOfAll);
}

constexpr std::string_view kHalve = R"((top (Top))
(Top () :requires ((given ?n) (bind (?half ?rest) {halves ?n})) :means ((Say ?half ?rest)))
(Say (?a ?b) :action ({say ?a ?b} {update (said ?) (said ?a)})))";

TEST(ScriptRecorderTest, CyclesOfALayer_ComeOutTheSame) {
  testing::ProgramMind mind(kHalve);
  mind.Input("given", {sdk::ArgumentType::kAny});
  mind.Output("say", {sdk::ArgumentType::kInteger, sdk::ArgumentType::kInteger});
  mind.attachments = {std::make_shared<testing::Halves>()};
  mind.Load();
  ScriptRecorder recorder(mind.reasoner.program(), mind.reasoner.names());
  mind.reasoner.SetWatch(&recorder);
  std::vector<std::string> cycles;
  for (const char* const fact : {"given(7)", "given(7.5)", "given(13)", "given(-1)", "given(7)"}) {
    mind.Latch(0, {fact});
    mind.Decide();
    cycles.push_back(recorder.cycle());
  }
  const std::vector<std::string> expected = {
      "(cycle (store (given 7)) (answer {halves 7} (3 1)) (expect {say 3 1}{update (said ?) (said "
      "3)}))",
      "(cycle (update (given ?) (given 7.5)) (fail {halves 7.5} \"argument 1, 7.5, is not an "
      "integer\")\n       (expect false fault))",
      "(cycle (update (given ?) (given 13)) (fail {halves 13} \"thirteen\") (expect false fault))",
      "(cycle (update (given ?) (given -1)) (answer {halves -1} nil) (expect false))",
      "(cycle (update (given ?) (given 7)) (expect {say 3 1}{update (said ?) (said 3)}))"};
  EXPECT_EQ(cycles, expected);
  std::string script = "(top (Top))\n(functions halves)\n";
  for (const std::string& cycle : cycles) script += cycle + '\n';
  const testing::ScriptRun run(kHalve, script);
  EXPECT_EQ(run.faults(), (std::vector<std::string>{"{halves}: argument 1, 7.5, is not an integer",
                                                    "{halves}: thirteen"}));
  mind.reasoner.SetWatch(nullptr);
  mind.Decide();
  EXPECT_EQ(recorder.cycle(), cycles.back());
}

TEST(AnswerTableTest, TheAnswerThatWasSetLast_Holds) {
  const Value one = Value::Integer(1);
  const Value two = Value::Integer(2);
  const ScriptAnswer of_one{0, {one}, Value::Integer(10)};
  const ScriptAnswer of_all{0, {Value()}, Value::Integer(20)};
  const ScriptAnswer again{0, {one}, Value::Integer(30)};
  const ScriptAnswer other{1, {one}, Value::Integer(40)};
  AnswerTable table;
  const std::vector<Value> ask_one = {one};
  const std::vector<Value> ask_two = {two};
  EXPECT_EQ(table.Find(0, ask_one), nullptr);
  table.Set(of_one);
  table.Set(other);
  EXPECT_EQ(table.Find(0, ask_one), &of_one);
  EXPECT_EQ(table.Find(0, ask_two), nullptr);
  table.Set(of_all);
  EXPECT_EQ(table.Find(0, ask_one), &of_all);
  EXPECT_EQ(table.Find(0, ask_two), &of_all);
  table.Set(again);
  EXPECT_EQ(table.Find(0, ask_one), &again);
  EXPECT_EQ(table.Find(0, ask_two), &of_all);
  EXPECT_EQ(table.Find(1, ask_one), &other);
}

}  // namespace
}  // namespace latchwork::icarus
