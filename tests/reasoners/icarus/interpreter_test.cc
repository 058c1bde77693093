// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/interpreter.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tests/counted_allocations.h"
#include "tests/reasoners/icarus/script_run.h"

namespace latchwork::icarus::testing {
namespace {

/// {broken} throws; {count} answers how often it was asked, {noted x} is False.
class OddHost : public Host {
 public:
  std::span<const Signature> functions() const override {
    static constexpr std::array<Signature, 3> kFunctions = {
        {{"broken", 0, 0}, {"count", 0, 0}, {"noted", 1, 1}}};
    return kFunctions;
  }
  Value Call(std::size_t function, std::span<const Value> /*arguments*/, Arena& /*arena*/,
             NamePool& /*names*/) override {
    if (function == 0) throw std::runtime_error("the sonar is lost");
    return function == 1 ? Value::Integer(++asked) : Value();
  }
  std::int64_t asked = 0;
};

/// A program under OddHost.
struct Odd {
  explicit Odd(std::string_view text, std::string_view call, const RunOptions& options = {})
      : file(ReadProgram(std::string(text), "p.icarus")),
        interpreter(file.program, host, names, options) {
    top = interpreter.AddTop(std::string(call), findings);
  }
  ProgramFile file;
  NamePool names;
  OddHost host;
  Interpreter interpreter;
  Findings findings;
  std::size_t top = 0;
};

TEST(IcarusInterpreterTest, HostThatThrows_IsAFaultWithItsSkills) {
  Odd odd(
      "(Top () :objective ((Look)) :means ((Go)))\n(Look () :objective ({broken}))\n"
      "(Go () :action ({go}))",
      "(Top)");
  const CycleResult& result = odd.interpreter.Cycle(odd.top);
  ASSERT_EQ(result.fault_count, 1U);
  EXPECT_EQ(result.faults[0].message, "{broken}: the sonar is lost");
  EXPECT_EQ(result.faults[0].skills, (std::vector<std::string>{"Look", "Top"}));
  EXPECT_EQ(odd.file.program.source.at(result.faults[0].form).line, 2U);
  ASSERT_EQ(result.acts.size(), 1U);
  EXPECT_EQ(ToString(result.acts[0], odd.names), "{go}");
}

TEST(IcarusInterpreterTest, Sensors_AreAskedOncePerCycle) {
  Odd odd("(Top (?a ?b) :objective ((bind ?a {count}) (bind ?b {count})))", "(Top ?x ?y)");
  for (int cycle = 1; cycle <= 3; ++cycle) {
    const CycleResult& result = odd.interpreter.Cycle(odd.top);
    ASSERT_EQ(result.environments, 1U);
    EXPECT_EQ(result.values[0].integer, cycle);
    EXPECT_EQ(result.values[1].integer, cycle);
  }
}

TEST(IcarusInterpreterTest, UnboundVariables_AreFaultsNotCrashes) {
  Odd odd(
      "(Top () :requires ((*not* {noted ?x}) (*not* (Twice ?x))) :means ((Go ?x)))\n"
      "(Twice (?x) :objective ((bind ?x ?y) {noted ?y}))\n(Go (?x) :action ({go ?x}))",
      "(Top)");
  const CycleResult& result = odd.interpreter.Cycle(odd.top);
  EXPECT_EQ(result.fault_count, 3U);
  EXPECT_EQ(result.acts.size(), 0U);
}

TEST(IcarusInterpreterTest, Recursion_EndsAtTheLimits) {
  constexpr std::string_view kText =
      "(Down (?n) :requires ((bind ?m {+ ?n 1})) :means ((Down ?m) (Down ?m)))";
  RunOptions options;
  options.max_depth = 100'000;
  options.max_clauses = 50'000;
  Odd wide(kText, "(Down 0)", options);
  const CycleResult& stopped = wide.interpreter.Cycle(wide.top);
  EXPECT_FALSE(stopped.is_whole);
  EXPECT_LE(stopped.clauses, 50'001U);
  EXPECT_EQ(stopped.faults[0].message, "the cycle evaluates more clauses than the limit");
  Odd deep("(Down (?n) :requires ((bind ?m {+ ?n 1})) :means ((Down ?m)))", "(Down 0)");
  EXPECT_EQ(deep.interpreter.Cycle(deep.top).clauses, 2001U);
}

TEST(IcarusInterpreterTest, UnknownFunctions_AreFoundWhenLoading) {
  Odd odd("(Top () :objective ({cuont}))", "(Top)");
  ASSERT_EQ(odd.interpreter.findings().size(), 1U);
  EXPECT_EQ(odd.interpreter.findings()[0].code, Code::kUnknownFunction);
  EXPECT_EQ(odd.interpreter.findings()[0].diagnostic.hint, "did you mean {count}?");
}

TEST(IcarusInterpreterTest, Enumeration_SeesMemoryAsItWasWhenItBegan) {
  ScriptRun run(
      "(facts (n 1) (n 2))\n(Top () :requires ((n ?x)) :means ((More ?x)))\n"
      "(More (?x) :sensor ((bind ?y {+ ?x 10}) {store (n ?y)} {forget (n 2)}))",
      "(top (Top)) (cycle (expect true)) (cycle (expect true))");
  EXPECT_EQ(run.Memory(), "(n 1)(n 11)(n 12)(n 21)(n 22)");
}

TEST(IcarusInterpreterTest, ExpandedMeans_AreTheFirstOrTheBest) {
  constexpr std::string_view kText =
      "(Top () :means ((A) (B) (C)))\n(A () :action ({a}) :value 1)\n"
      "(B () :action ({b}) :value 3)\n(C () :action ({c}) :value 2)";
  RunOptions options;
  options.acts = ActMode::kAll;
  options.means = 2;
  options.expansion = Expansion::kFirst;
  ScriptRun first(kText, "(top (Top)) (cycle (expect {a} {b}))", options);
  options.expansion = Expansion::kBest;
  ScriptRun best(kText, "(top (Top)) (cycle (expect {b} {c}))", options);
  EXPECT_TRUE(best.faults().empty());
}

TEST(IcarusInterpreterTest, Acts_StartContinueAndStop) {
  Odd odd("(Top (?n) :means ((Go ?n)))\n(Go (?n) :action ({go ?n}))", "(Top 1)");
  const std::size_t other = odd.interpreter.AddTop("(Top 2)", odd.findings);
  EXPECT_TRUE(odd.interpreter.Cycle(odd.top).acts[0].started);
  EXPECT_FALSE(odd.interpreter.Cycle(odd.top).acts[0].started);
  const CycleResult& changed = odd.interpreter.Cycle(other);
  EXPECT_TRUE(changed.acts[0].started);
  ASSERT_EQ(changed.stopped.size(), 1U);
  EXPECT_EQ(ToString(changed.stopped[0], odd.names), "{go 1}");
  const CycleResult& idle = odd.interpreter.Cycle(Interpreter::kNoTop);
  EXPECT_EQ(idle.acts.size(), 0U);
  EXPECT_EQ(idle.stopped.size(), 1U);
}

TEST(IcarusInterpreterTest, WarmCycle_AllocatesNothing) {
  Odd odd(
      "(facts (car c1) (car c2) (at c1 (10 20)) (at c2 (30 40)))\n"
      "(Top () :requires ((car ?c) (*not* (Seen ?c)) (Where ?c ?l)) :means ((Walk ?c ?l)))\n"
      "(Seen (?c) :objective ({noted ?c}))\n(Where (?c ?l) :objective ((at ?c ?l)))\n"
      "(Walk (?c ?l) :sequence ((Note ?c) (Go ?c ?l)))\n"
      "(Note (?c) :sensor ((bind ?n {count}) {update (noted ?c ?) (noted ?c ?n)}))\n"
      "(Go (?c ?l) :action ({go ?c (?l ?c)}))",
      "(Top)");
  for (int i = 0; i < 50; ++i) odd.interpreter.Cycle(odd.top);
  const std::size_t before = test::Allocations();
  std::size_t acts = 0;
  for (int i = 0; i < 50; ++i) acts += odd.interpreter.Cycle(odd.top).acts.size();
  EXPECT_EQ(test::Allocations(), before);
  EXPECT_EQ(acts, 50U);
}

}  // namespace
}  // namespace latchwork::icarus::testing
