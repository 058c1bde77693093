// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/interpreter.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tests/reasoners/icarus/allocations.h"
#include "tests/reasoners/icarus/script_run.h"
#include "tests/reasoners/icarus/trees.h"

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

TEST(IcarusInterpreterTest, Tops_AreCallsThatFitTheirSkill) {
  Odd odd("(Top (?x) :means ((Go ?x)))\n(Go (?x) :action ({go ?x}))", "(Top 1)");
  EXPECT_TRUE(odd.findings.empty());
  for (const char* const top : {"(Top 1 2)", "(*not* (Top 1))", "(bind ?x 3)", "(Stop)", "{go}"}) {
    Findings findings;
    EXPECT_EQ(odd.interpreter.AddTop(top, findings), Interpreter::kNoTop) << top;
    EXPECT_EQ(findings.size(), 1U) << top;
  }
  EXPECT_EQ(odd.interpreter.Cycle(odd.top).acts.size(), 1U);
}

/// What acts do to memory is done at the end of the cycle, in every tool.
TEST(IcarusInterpreterTest, ActsThatChangeMemory_DoSoWhenTheyAreIssued) {
  ScriptRun run(
      "(facts (old 1) (old (2 3)) (kept 1))\n(Top () :requires ((*not* (noted x))) :means ((N) "
      "(M)))\n"
      "(N () :requires ((old ?)) :means ((Note)))\n"
      "(Note () :action ({do x} {store (noted x)} {forget (old ?)} {update (kept ?) (kept 2)}))\n"
      "(M () :action ({m}))",
      "(top (Top)) (cycle (expect {do x} {store (noted x)} {forget (old ?)} {update (kept ?) (kept "
      "2)}))"
      "(cycle (repeat 2) (expect false))");
  EXPECT_EQ(run.Memory(), "(kept 2)(noted x)");
  EXPECT_TRUE(run.faults().empty());
}

TEST(IcarusInterpreterTest, ActsThatWouldStoreNoList_AreNotOffered) {
  ScriptRun run(
      "(Top () :means ((A 1) (B ?x)))\n(A (?x) :action ({store ?x}))\n"
      "(B (?x) :action ({forget (p ?x)}))",
      "(top (Top)) (cycle (expect false fault))");
  EXPECT_EQ(run.faults(),
            (std::vector<std::string>{"memory holds lists only",
                                      "an argument of the call has an unbound variable"}));
}

/// Asked twice in a cycle, a sequence that has ended begins again in the next.
TEST(IcarusInterpreterTest, Restart_IsInTheNextCycle) {
  RunOptions options;
  options.restart = true;
  options.acts = ActMode::kAll;
  ScriptRun run(
      "(facts (p 1) (p 2))\n(Top () :requires ((p ?)) :means ((Both)))\n"
      "(Both () :sequence ((First) (Second)))\n"
      "(First () :objective ({one}) :means ((Do 1)))\n"
      "(Second () :objective ({two}) :means ((Do 2)))\n(Do (?n) :action ({do ?n}))",
      "(top (Top)) (cycle (expect {do 1})) (cycle (answer {one} t) (expect {do 2}))"
      "(cycle (answer {two} t) (answer {one} nil) (expect true)) (cycle (expect {do 1}))",
      options);
}

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

TEST(IcarusInterpreterTest, FaultModes_DecideWhatAFaultEnds) {
  constexpr std::string_view kText =
      "(Top (?n) :objective ({< ?n 0}) :means ((Go ?n) (Look ?n)))\n(Go (?n) :action ({go ?n}))\n"
      "(Look (?n) :requires ({> ?n 1} {broken}))";
  for (const FaultMode mode : {FaultMode::kFalse, FaultMode::kAbortCycle, FaultMode::kStop}) {
    RunOptions options;
    options.faults = mode;
    options.acts = ActMode::kAll;
    Odd odd(kText, "(Top 1)", options);
    const std::size_t faulty = odd.interpreter.AddTop("(Top 2)", odd.findings);
    EXPECT_EQ(odd.interpreter.Cycle(odd.top).acts.size(), 1U);
    const CycleResult& result = odd.interpreter.Cycle(faulty);
    EXPECT_EQ(result.fault_count, 1U);
    EXPECT_EQ(result.acts.size(), mode == FaultMode::kFalse ? 1U : 0U);
    EXPECT_EQ(result.stopped.size(), 1U);
    EXPECT_EQ(result.is_aborted, mode != FaultMode::kFalse);
    EXPECT_EQ(odd.interpreter.Cycle(odd.top).acts.size(), mode == FaultMode::kStop ? 0U : 1U);
  }
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

/// `Top Near(c1) Go`, with what each skill was called with.
std::string PathText(const Odd& odd, const Act& act) {
  std::vector<const PathSkill*> path;
  GetPath(act, path);
  std::string text;
  for (const PathSkill* at : path) {
    text += (text.empty() ? "" : " ") + odd.file.program.skills[at->skill].spelling + '(';
    for (const Value& value : at->arguments) {
      text += value.is_none() ? "?" : ToString(value, odd.names);
    }
    text += ')';
  }
  return text;
}

TEST(IcarusInterpreterTest, Acts_CarryTheSkillsThatLedToThem) {
  constexpr std::string_view kText =
      "(facts (car c1) (car c2))\n"
      "(Top (?far) :requires ((car ?c) (*not* {noted ?c})) :means ((Drive ?c ?far) (Look)))\n"
      "(Drive (?c ?d) :sequence ((Near ?c ?l) (Go ?l)))\n"
      "(Near (?c ?l) :objective ((bind ?l (at ?c))))\n"
      "(Look () :means ((*not* (Go look))))\n"
      "(Go (?x) :action ({go ?x}))";
  for (const ActMode mode : {ActMode::kAll, ActMode::kValue, ActMode::kFirst}) {
    RunOptions options;
    options.acts = mode;
    Odd odd(kText, "(Top ?)", options);
    const CycleResult& result = odd.interpreter.Cycle(odd.top);
    EXPECT_EQ(PathText(odd, result.acts[0]), "Top(?) Drive(c1?) Go((at c1))");
    if (mode != ActMode::kAll) continue;
    ASSERT_EQ(result.acts.size(), 3U);
    EXPECT_EQ(PathText(odd, result.acts[1]), "Top(?) Look() Go(look)");
    EXPECT_EQ(PathText(odd, result.acts[2]), "Top(?) Drive(c2?) Go((at c2))");
    EXPECT_EQ(odd.file.program.source.at(result.acts[2].path->form).line, 3U);
    EXPECT_EQ(odd.interpreter.Cycle(Interpreter::kNoTop).stopped[0].path, nullptr);
  }
}

TEST(IcarusInterpreterTest, Paths_TakeMemoryInProportionToCalls) {
  RunOptions options;
  options.acts = ActMode::kAll;
  options.max_depth = 20'000;
  Odd odd(
      "(Deep (?n) :requires ({< ?n 9999} (bind ?m {+ ?n 1})) :means ((Deep ?m) (Go ?n)))\n"
      "(Go (?n) :action ({go 1}))",
      "(Deep 0)", options);
  const CycleResult& result = odd.interpreter.Cycle(odd.top);
  ASSERT_EQ(result.acts.size(), 1U);
  std::vector<const PathSkill*> path;
  GetPath(result.acts[0], path);
  EXPECT_EQ(path.size(), 10'000U);
}

TEST(IcarusInterpreterTest, TakeOver_ReplacesTheStatesOfSequences) {
  constexpr std::string_view kText =
      "(Steps (?n) :sequence ((Fact ?n) (Go ?n)))\n(Fact (?n) :sensor ({store (at ?n)}))\n"
      "(Go (?n) :action ({go ?n}))";
  Odd before(kText, "(Steps 1)");
  Odd after(kText, "(Steps 2)");
  before.interpreter.Cycle(before.top);
  after.interpreter.Cycle(after.top);
  ASSERT_EQ(after.interpreter.sequence_states(), 1U);
  after.interpreter.TakeOver(before.interpreter, after.file.program.facts.size());
  EXPECT_EQ(after.interpreter.sequence_states(), 1U) << "that of (Steps 1) alone";
  EXPECT_EQ(after.interpreter.cycle(), 1U);
}

/// Asks a sensor with other arguments in each cycle, by two ways.
TEST(IcarusInterpreterTest, SensorAskedOfEverNewValues_KeepsItsMemory) {
  Odd odd(
      "(facts (count 0))\n(Top () :requires ((Next ?n) (*not* (Seen ?n)) (*not* {noted ?n})))\n"
      "(Next (?n) :sensor ((bind ?n {count}) {update (count ?) (count ?n)}))\n"
      "(Seen (?n) :requires ((count ?m) (*not* {noted (a ?m)}) {noted (a ?n)}))",
      "(Top)");
  for (int i = 0; i < 1000; ++i) odd.interpreter.Cycle(odd.top);
  const std::size_t before = Allocations();
  for (int i = 0; i < 1000; ++i) odd.interpreter.Cycle(odd.top);
  EXPECT_EQ(Allocations(), before);
  EXPECT_EQ(odd.host.asked, 2000);
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
  const std::size_t before = Allocations();
  std::size_t acts = 0;
  for (int i = 0; i < 50; ++i) acts += odd.interpreter.Cycle(odd.top).acts.size();
  EXPECT_EQ(Allocations(), before);
  EXPECT_EQ(acts, 50U);
}

TEST(IcarusInterpreterTest, WarmCycleOfATree_AllocatesNothing) {
  for (const std::string& text : {FlatTree(1000), LevelTree(200, true), ManyFacts(300, 100)}) {
    for (const ActMode mode : {ActMode::kFirst, ActMode::kAll, ActMode::kValue}) {
      RunOptions options;
      options.acts = mode;
      TreeRun run(text, options);
      for (int i = 0; i < 3; ++i) ASSERT_EQ(run.Cycle().acts.size(), 1U);
      const std::size_t before = Allocations();
      for (int i = 0; i < 10; ++i) run.Cycle();
      EXPECT_EQ(Allocations(), before);
    }
  }
}

}  // namespace
}  // namespace latchwork::icarus::testing
