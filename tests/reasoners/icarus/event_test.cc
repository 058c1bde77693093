// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/tools/profile.h"
#include "reasoners/icarus/tools/trace_entry.h"
#include "reasoners/icarus/tools/world_script.h"
#include "tests/reasoners/icarus/random_program.h"

namespace latchwork::icarus::testing {
namespace {

/// Runs a program in a scripted world and keeps the lines of its trace.
class Traced : public EventSink {
 public:
  Traced(std::string_view program, std::string_view script, const RunOptions& options = {})
      : file_(ReadProgram(std::string(program), "p.icarus")),
        script_(ReadScript(std::string(script), "w.world", names_, findings_)),
        world_(script_),
        interpreter_(file_.program, world_, names_, options),
        profile_(file_.program) {
    top_ = interpreter_.AddTop(script_.top, findings_);
    EXPECT_TRUE(findings_.empty() && interpreter_.findings().empty());
    interpreter_.SetSink(this);
    for (const ScriptCycle& cycle : script_.cycles) {
      world_.Begin(cycle, interpreter_.memory());
      result_ = &interpreter_.Cycle(top_);
    }
  }

  void OnEvent(const Event& event) override {
    profile_.OnEvent(event);
    entries_.push_back(EventDescriber(file_.program, interpreter_.TopSource(top_),
                                      interpreter_.TopVariables(top_), names_)
                           .Describe(event));
  }

  std::string Text() const {
    std::string text;
    for (const TraceEntry& entry : entries_) {
      const std::string line = TraceLine(entry);
      if (!line.empty()) text += line + '\n';
    }
    return text;
  }
  const std::vector<TraceEntry>& entries() const { return entries_; }
  const SkillProfile& profile() const { return profile_; }
  const CycleResult& result() const { return *result_; }

 private:
  NamePool names_;
  Findings findings_;
  ProgramFile file_;
  WorldScript script_;
  ScriptedWorld world_;
  Interpreter interpreter_;
  SkillProfile profile_;
  std::size_t top_ = 0;
  std::vector<TraceEntry> entries_;
  const CycleResult* result_ = nullptr;
};

TEST(IcarusEventTest, Plan_TellsConditionsAndMeans) {
  const Traced traced(
      "(constant *OneCarLength* 1.0)\n"
      "(Near (?car)\n"
      "  :objective ((Distance ?car ?d) {< ?d *OneCarLength*})\n"
      "  :requires ((*not* {blocked}))\n"
      "  :means ((Go ?car)))\n"
      "(Distance (?car ?d) :sensor ((bind ?d {range-to ?car})))\n"
      "(Go (?car) :action ({go ?car}))",
      "(functions blocked) (top (Near car1)) (cycle (answer {range-to car1} 3.0))");
  EXPECT_EQ(traced.Text(),
            "        (Near car1)\n"
            "3:15      (Distance car1 ?d)\n"
            "6:39        {range-to car1} = 3.0\n"
            "6:30        (bind ?d {range-to car1}) True ?d=3.0\n"
            "3:15      (Distance car1 ?d) True ?d=3.0\n"
            "3:34      {< 3.0 *OneCarLength*} False\n"
            "          objective False\n"
            "4:21      {blocked} = nil\n"
            "4:21      {blocked} False\n"
            "4:14      (*not* {blocked}) True\n"
            "5:11      means 1 (Go car1)\n"
            "5:11      (Go car1)\n"
            "5:11        act {go car1}\n"
            "5:11    chosen {go car1}\n");
}

TEST(IcarusEventTest, MatchesWritesAndDroppedActs_AreTold) {
  const Traced traced(
      "(facts (car c1) (car c2))\n"
      "(Top () :requires ((car ?c) (Note ?c)) :means ((Go ?c)))\n"
      "(Note (?c) :sensor ({update (seen ?) (seen ?c)}))\n"
      "(Go (?c) :action ({go ?c}))",
      "(top (Top)) (cycle)", [] {
        RunOptions options;
        options.lazy = false;
        return options;
      }());
  EXPECT_EQ(traced.Text(),
            "        (Top)\n"
            "2:20      (car ?c) True ?c=c1\n"
            "2:29      (Note c1)\n"
            "3:21        store (seen c1)\n"
            "3:21        {update (seen ?) (seen c1)} True\n"
            "2:29      (Note c1) True\n"
            "2:48      means 1 (Go c1)\n"
            "2:48      (Go c1)\n"
            "2:48        act {go c1}\n"
            "2:48      (Go c1) acts\n"
            "2:20      (car ?c) True ?c=c2\n"
            "2:29      (Note c2)\n"
            "3:21        forget (seen c1)\n"
            "3:21        store (seen c2)\n"
            "3:21        {update (seen ?) (seen c2)} True\n"
            "2:29      (Note c2) True\n"
            "2:48      means 1 (Go c2)\n"
            "2:48      (Go c2)\n"
            "2:48        act {go c2}\n"
            "2:48      dropped {go c2}\n"
            "2:48      (Go c2) acts\n"
            "        (Top) acts\n"
            "2:48    chosen {go c1}\n");
}

TEST(IcarusEventTest, SequencesAndFaults_AreTold) {
  const Traced traced(
      "(Top () :sequence ((Pay ?x) (Ride)))\n"
      "(Pay (?x) :objective ((paid ?x)))\n"
      "(Ride () :means ({spin ?y} (Go)))\n"
      "(Go () :action ({go}))",
      "(functions spin) (top (Top)) (cycle (store (paid 3)))");
  EXPECT_EQ(traced.Text(),
            "        (Top)\n"
            "1:20      step 1 (Pay ?x)\n"
            "1:20      (Pay ?x)\n"
            "2:23        (paid ?x) True ?x=3\n"
            "1:20      (Pay ?x) True ?x=3\n"
            "1:20      step 1 True\n"
            "1:29      step 2 (Ride)\n"
            "1:29      (Ride)\n"
            "3:18        means 1 {spin ?y}\n"
            "3:18        fault: an argument of the call has an unbound variable\n"
            "3:18        {spin ?y} False\n"
            "3:28        means 2 (Go)\n"
            "3:28        (Go)\n"
            "3:28          act {go}\n"
            "3:28        (Go) acts\n"
            "1:29      (Ride) acts\n"
            "1:29      step 2 acts\n"
            "        (Top) acts\n"
            "3:28    chosen {go}\n");
}

TEST(IcarusEventTest, Profile_CountsTheClausesOfEachSkill) {
  const Traced traced(
      "(facts (car c1) (car c2))\n"
      "(Top () :requires ((car ?c) {fast ?c}) :means ((Go ?c)))\n"
      "(Go (?c) :action ({go ?c}))",
      "(top (Top)) (cycle (answer {fast c2} t))");
  const std::vector<SkillProfile::Counts>& counts = traced.profile().counts();
  EXPECT_EQ(counts[0].clauses, 4U);
  EXPECT_EQ(counts[0].host, 2U);
  EXPECT_EQ(counts[1].calls, 1U);
  EXPECT_EQ(counts[1].chosen, 1U);
  EXPECT_EQ(traced.profile().Table(),
            "   clauses     calls     false      host      acts    chosen  skill\n"
            "         4         1         0         2         0         0  Top\n"
            "         0         1         0         0         1         1  Go\n");
}

/// A sink that changes nothing and forgets everything.
class Deaf : public EventSink {
 public:
  void OnEvent(const Event& event) override { told += event.number == 0 ? 0 : 1; }
  std::size_t told = 0;
};

TEST(IcarusEventTest, Tracing_ChangesNothing) {
  constexpr std::array<ActMode, 3> kModes = {ActMode::kFirst, ActMode::kAll, ActMode::kValue};
  constexpr std::string_view kScript =
      "(top (s0)) (cycle (answer {f0 a} t) (answer {f1 b} t) (answer {v a} b) (answer {f2 ?} t))";
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const ProgramFile file = ReadProgram(RandomProgram(seed, {}).Text(), "p.icarus");
    RunOptions options;
    options.max_depth = 9;
    options.max_clauses = 20'000;
    options.acts = kModes[seed % 3];
    std::array<std::string, 2> outcomes;
    Deaf sink;
    for (const bool traced : {false, true}) {
      NamePool names;
      Findings findings;
      const WorldScript script =
          ReadScript("(functions f0 f1 f2 v)" + std::string(kScript), "w", names, findings);
      ScriptedWorld world(script);
      Interpreter interpreter(file.program, world, names, options);
      if (traced) interpreter.SetSink(&sink);
      const std::size_t top = interpreter.AddTop("(s0)", findings);
      for (int cycle = 0; cycle < 3; ++cycle) {
        world.Begin(script.cycles[0], interpreter.memory());
        const CycleResult& result = interpreter.Cycle(top);
        for (const std::string& word : Outcome(result, names)) outcomes[traced] += word + ' ';
        outcomes[traced] += std::to_string(result.environments) + ' ' +
                            std::to_string(result.clauses) + ' ' +
                            std::to_string(result.fault_count) + '\n';
      }
    }
    ASSERT_EQ(outcomes[0], outcomes[1]) << seed;
    EXPECT_GT(sink.told, 0U);
  }
}

}  // namespace
}  // namespace latchwork::icarus::testing
