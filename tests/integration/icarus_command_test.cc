// SPDX-License-Identifier: BSD-3-Clause
//
// `latchwork icarus` as it is used: exit codes, and what goes to which stream.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using test::TemporaryFolder;
constexpr const char* kGood = "(Go () :action ({go}))\n";
constexpr const char* kWarned = "(Top () :means ((Goo)))\n(Go () :action ({go}))\n";
constexpr const char* kBad = "(Go () :acton ({go}))\n(Run (x) :action ({run}))\n";

class IcarusCommandTest : public ::testing::Test {
 protected:
  CommandResult Icarus(std::vector<std::string> arguments, const std::string& text) {
    WriteText(scratch_.path() / "p.icarus", text);
    arguments.insert(arguments.begin(), "icarus");
    return RunLatchwork(arguments, scratch_.path());
  }

  TemporaryFolder scratch_;
};

TEST_F(IcarusCommandTest, Check_GoodProgram_IsSummedUp) {
  const CommandResult result = Icarus({"check", "p.icarus"}, kGood);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "p.icarus: ok: 1 skill, 0 constants, 0 facts\n");
  EXPECT_EQ(result.err, "");
}

TEST_F(IcarusCommandTest, Check_Warnings_CountWhenAsked) {
  EXPECT_EQ(Icarus({"check", "p.icarus"}, kWarned).exit_code, 0);
  EXPECT_EQ(Icarus({"check", "--werror", "p.icarus"}, kWarned).exit_code, 3);
}

TEST_F(IcarusCommandTest, Check_BadProgram_ShowsAllErrors) {
  const CommandResult result = Icarus({"check", "p.icarus"}, kBad);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("p.icarus:1:8: error[I006]"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("did you mean ':action'?"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("p.icarus:2:7: error[I005]"), std::string::npos) << result.err;
}

TEST_F(IcarusCommandTest, Check_Json_ListsFindings) {
  const CommandResult result = Icarus({"check", "--json", "p.icarus"}, kBad);
  EXPECT_EQ(result.exit_code, 3);
  const auto list = nlohmann::json::parse(result.out);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0]["code"], "I006");
  EXPECT_EQ(list[1]["line"], 2);
}

TEST_F(IcarusCommandTest, Check_UnknownFileOrCode_IsRefused) {
  EXPECT_EQ(Icarus({"check", "absent.icarus"}, kGood).exit_code, 3);
  EXPECT_EQ(Icarus({"check", "--explain", "I999"}, kGood).exit_code, 2);
  EXPECT_EQ(Icarus({"check", "--explain", "i015"}, kGood).exit_code, 0);
}

TEST_F(IcarusCommandTest, Format_RewritesInPlaceOnce) {
  const std::string untidy = "(Go ()\n :action   ({go}))";
  EXPECT_EQ(Icarus({"fmt", "--check", "p.icarus"}, untidy).exit_code, 1);
  EXPECT_EQ(ReadText(scratch_.path() / "p.icarus"), untidy);
  const CommandResult result = Icarus({"fmt", "p.icarus"}, untidy);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "p.icarus\n");
  EXPECT_EQ(ReadText(scratch_.path() / "p.icarus"), kGood);
  EXPECT_EQ(Icarus({"fmt", "--check", "p.icarus"}, kGood).exit_code, 0);
}

TEST_F(IcarusCommandTest, Format_KeepsLinksAndPermissions) {
  namespace fs = std::filesystem;
  WriteText(scratch_.path() / "real.icarus", "(Go ()\n :action   ({go}))");
  constexpr fs::perms kMode = fs::perms::owner_all | fs::perms::group_read;
  fs::permissions(scratch_.path() / "real.icarus", kMode);
  fs::create_symlink("real.icarus", scratch_.path() / "link.icarus");
  EXPECT_EQ(Icarus({"fmt", "link.icarus"}, kGood).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(scratch_.path() / "link.icarus"));
  EXPECT_EQ(ReadText(scratch_.path() / "real.icarus"), kGood);
  EXPECT_EQ(fs::status(scratch_.path() / "real.icarus").permissions(), kMode);
}

TEST_F(IcarusCommandTest, Format_BrokenProgram_IsLeftAlone) {
  const std::string broken = "(Go () :action ({go}))\n(Run";
  EXPECT_EQ(Icarus({"fmt", "p.icarus"}, broken).exit_code, 3);
  EXPECT_EQ(ReadText(scratch_.path() / "p.icarus"), broken);
}

constexpr const char* kNear =
    "(Near (?car ?d) :objective ((Distance ?car ?d) {< ?d 1.0}) :means ((GoForward)))\n"
    "(Distance (?car ?d) :sensor ((bind ?d {range-to ?car})))\n"
    "(GoForward () :action ({goforward}))\n";
constexpr const char* kApproach =
    "(top (Near car1 ?d))\n(cycle (answer {range-to car1} 3.0) (expect {goforward}))\n"
    "(cycle (expect {goforward}))\n(cycle (answer {range-to car1} 0.5) (expect true))\n";

TEST_F(IcarusCommandTest, Run_BadTopsOfAScript_AreFoundInIt) {
  WriteText(scratch_.path() / "w.world",
            "(top (Near a b c))\n(functions range-to)\n(cycle (top (Far)))\n");
  const CommandResult result = Icarus({"run", "p.icarus", "--script", "w.world"}, kNear);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("w.world:1:6: error[I011]"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("w.world:3:14: error[I030]"), std::string::npos) << result.err;
}

TEST_F(IcarusCommandTest, Run_ScriptThatMeansNothing_IsRefused) {
  WriteText(scratch_.path() / "w.world",
            "(top (Near a))\n(top (Near b))\n(functions 3)\n(cycle (answer {< ? ?} t))\n"
            "(cycle (answer {f 1} t) (answer {f 1 2} t) (repeat 2) (repeat 3))\n");
  const CommandResult result = Icarus({"run", "p.icarus", "--script", "w.world"}, kNear);
  EXPECT_EQ(result.exit_code, 3);
  for (const char* const place : {"2:1", "3:12", "4:17", "5:33", "5:55"}) {
    EXPECT_NE(result.err.find("w.world:" + std::string(place) + ": error[I029]"), std::string::npos)
        << place << '\n'
        << result.err;
  }
}

TEST_F(IcarusCommandTest, Run_FunctionThatTheScriptLacks_SaysHowToDeclareIt) {
  WriteText(scratch_.path() / "w.world", "(top (Near a))\n(cycle)\n");
  const CommandResult result = Icarus({"run", "p.icarus", "--script", "w.world"}, kNear);
  EXPECT_NE(result.err.find("(functions range-to)"), std::string::npos) << result.err;
}

TEST_F(IcarusCommandTest, Run_Json_TellsAbortedCycles) {
  WriteText(scratch_.path() / "w.world", "(top (A b))\n(cycle)\n");
  const CommandResult result =
      Icarus({"run", "p.icarus", "--script", "w.world", "--faults", "abort-cycle", "--json"},
             "(A (?x) :requires ({< ?x 1}) :means ((Go)))\n(Go () :action ({go}))\n");
  EXPECT_EQ(nlohmann::json::parse(result.out)["aborted"], true) << result.out;
}

TEST_F(IcarusCommandTest, Run_OptionsWithoutEffect_AreRefused) {
  WriteText(scratch_.path() / "w.world", kApproach);
  EXPECT_EQ(Icarus({"run", "p.icarus", "--script", "w.world", "--means", "3"}, kNear).exit_code, 2);
  EXPECT_EQ(Icarus({"trace", "p.icarus", "--replay", "t.jsonl", "--acts", "all"}, kNear).exit_code,
            2);
}

TEST_F(IcarusCommandTest, Run_ScriptedWorld_PrintsActsAndTruth) {
  WriteText(scratch_.path() / "w.world", kApproach);
  const CommandResult result = Icarus({"run", "p.icarus", "--script", "w.world"}, kNear);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            "1: start {goforward}\n2: continue {goforward}\n"
            "3: stop {goforward} True ?d=0.5\n");
}

TEST_F(IcarusCommandTest, Run_BeginsWithTheTopOfTheProgram) {
  WriteText(scratch_.path() / "w.world", "(cycle (expect {go}))");
  const auto run = [&](const std::string& program, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"run", "p.icarus", "--script", "w.world"});
    return Icarus(more, program);
  };
  EXPECT_EQ(run("(top (Go))\n(Go () :action ({go}))\n").exit_code, 0);
  EXPECT_EQ(run("(top (Stay))\n(Go () :action ({go}))\n(Stay () :action ({stay}))\n").exit_code, 1);
  EXPECT_EQ(
      run("(top (Stay))\n(Go () :action ({go}))\n(Stay () :action ({stay}))\n", {"--top", "(Go)"})
          .exit_code,
      0);
  EXPECT_NE(run(kGood).err.find("no top call is given"), std::string::npos);
}

TEST_F(IcarusCommandTest, Run_Json_IsOneObjectPerCycle) {
  WriteText(scratch_.path() / "w.world", kApproach);
  const CommandResult result = Icarus({"run", "p.icarus", "--script", "w.world", "--json"}, kNear);
  const auto first = nlohmann::json::parse(result.out.substr(0, result.out.find('\n')));
  EXPECT_EQ(first["acts"][0], "{goforward}");
  EXPECT_EQ(first["clauses"], 5);
}

TEST_F(IcarusCommandTest, Run_UnmetExpectation_IsReported) {
  WriteText(scratch_.path() / "w.world",
            "(top (Near car1 ?))\n(cycle (answer {range-to car1} far) (expect true))\n");
  const CommandResult result = Icarus({"run", "p.icarus", "--script", "w.world"}, kNear);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("p.icarus:1:48: fault in cycle 1"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("w.world:2: cycle 1 is not as expected: true"), std::string::npos)
      << result.err;
}

TEST_F(IcarusCommandTest, Run_BadScriptOrUnknownFunction_IsRefused) {
  WriteText(scratch_.path() / "w.world", "(top (Near car1 ?))\n(cycle (anser {f} t))\n");
  EXPECT_EQ(Icarus({"run", "p.icarus", "--script", "w.world"}, kNear).exit_code, 3);
  WriteText(scratch_.path() / "w.world", "(top (Near car1 ?))\n(cycle (answer {rangeto ?} 1))\n");
  const CommandResult result = Icarus({"run", "p.icarus", "--script", "w.world"}, kNear);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("did you mean {rangeto}?"), std::string::npos) << result.err;
}

constexpr const char* kGoNear =
    "(Near (?car)\n  :objective ((Distance ?car ?d) {< ?d 1.0})\n  :means ((Go)))\n"
    "(Distance (?car ?d) :sensor ((bind ?d {range-to ?car})))\n(Go () :action ({go}))\n";
constexpr const char* kGoNearWorld =
    "(top (Near car1))\n(cycle (answer {range-to car1} 3.0) (store (car car1)) (expect {go}))\n"
    "(cycle (answer {range-to car1} 0.5) (forget (car ?)) (expect true))\n(cycle (idle))\n";

TEST_F(IcarusCommandTest, Trace_Text_IsIndentedWithPlaces) {
  WriteText(scratch_.path() / "w.world", kGoNearWorld);
  const CommandResult result = Icarus({"trace", "p.icarus", "--script", "w.world"}, kGoNear);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out.find("cycle 1\n        (Near car1)\n2:15      (Distance car1 ?d)\n"), 0U)
      << result.out;
  EXPECT_NE(result.out.find("\n3:11    chosen {go}\n1: start {go}\ncycle 2\n"), std::string::npos)
      << result.out;
  const CommandResult skills =
      Icarus({"trace", "p.icarus", "--script", "w.world", "--level", "skill"}, kGoNear);
  EXPECT_EQ(skills.out.find("range-to"), std::string::npos) << skills.out;
}

TEST_F(IcarusCommandTest, Trace_Replayed_IsIdenticalOrNamesTheFirstDifference) {
  WriteText(scratch_.path() / "w.world", kGoNearWorld);
  const CommandResult trace =
      Icarus({"trace", "p.icarus", "--script", "w.world", "--json", "--acts", "all"}, kGoNear);
  ASSERT_EQ(trace.exit_code, 0) << trace.err;
  WriteText(scratch_.path() / "t.jsonl", trace.out);
  const std::vector<std::string> replay = {"trace", "--replay", "t.jsonl", "p.icarus"};
  const CommandResult same = Icarus(replay, "; The same.\n" + std::string(kGoNear));
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  EXPECT_EQ(same.out.find("identical: 3 cycles, "), 0U) << same.out;
  std::string changed = kGoNear;
  changed.replace(changed.find("1.0"), 3, "0.1");
  const CommandResult other = Icarus(replay, changed);
  EXPECT_EQ(other.exit_code, 6);
  EXPECT_NE(other.out.find("diverged in cycle 1, event 6\n"), std::string::npos) << other.out;
  EXPECT_NE(other.out.find("{< 3.0 0.1}"), std::string::npos) << other.out;
}

TEST_F(IcarusCommandTest, Trace_BadTraces_AreRefused) {
  const std::vector<std::string> replay = {"trace", "--replay", "t.jsonl", "p.icarus"};
  for (const char* text : {"", "{}", "nothing", "[1,2]", "{\"kind\":\"trace\"}\n{\"kind\":1}"}) {
    WriteText(scratch_.path() / "t.jsonl", text);
    const CommandResult result = Icarus(replay, kGoNear);
    EXPECT_EQ(result.exit_code, 3) << text;
    EXPECT_EQ(result.err.find("t.jsonl:"), 0U) << result.err;
  }
  EXPECT_EQ(Icarus({"trace", "p.icarus"}, kGoNear).exit_code, 2);
}

TEST_F(IcarusCommandTest, Run_FaultModes_EndTheCycleOrTheRun) {
  WriteText(scratch_.path() / "w.world",
            "(top (Near car1)) (functions range-to)\n(cycle (answer {range-to car1} far))\n"
            "(cycle (answer {range-to car1} 3))\n");
  const std::vector<std::string> run = {"run", "p.icarus", "--script", "w.world", "--faults"};
  const auto with = [&](const char* mode) {
    std::vector<std::string> arguments = run;
    arguments.emplace_back(mode);
    return Icarus(arguments, kGoNear);
  };
  EXPECT_EQ(with("false").out, "1: start {go}\n2: continue {go}\n");
  EXPECT_EQ(with("abort-cycle").out, "1: aborted\n2: start {go}\n");
  const CommandResult stopped = with("stop");
  EXPECT_EQ(stopped.out, "1: aborted\n");
  EXPECT_EQ(stopped.exit_code, 1);
}

TEST_F(IcarusCommandTest, Run_ActOfTwoCalls_IsExpectedAsAWhole) {
  const std::string program = "(Drive (?v) :action ({pedal ?v} {lights on}))\n";
  const auto run = [&](const std::string& expected, std::vector<std::string> more = {}) {
    WriteText(scratch_.path() / "w.world",
              "(top (Drive 20))\n(cycle (expect " + expected + "))\n(cycle (top (Drive 20)))\n");
    more.insert(more.begin(), {"run", "p.icarus", "--script", "w.world"});
    return Icarus(more, program);
  };
  const CommandResult both = run("{pedal 20} {lights on}");
  EXPECT_EQ(both.exit_code, 0) << both.err;
  EXPECT_EQ(both.out, "1: start {pedal 20}{lights on}\n2: continue {pedal 20}{lights on}\n");
  for (const char* other : {"{pedal 20}", "{lights on}", "{lights on} {pedal 20}"}) {
    const CommandResult result = run(other);
    EXPECT_EQ(result.exit_code, 1) << other;
    EXPECT_NE(result.err.find("cycle 1 is not as expected: {"), std::string::npos) << result.err;
  }
  const std::string line = run("{pedal 20} {lights on}", {"--json"}).out;
  const auto first = nlohmann::json::parse(line.substr(0, line.find('\n')));
  EXPECT_EQ(first["acts"], nlohmann::json({"{pedal 20}{lights on}"}));
  EXPECT_EQ(first["expected"], true);
}

TEST_F(IcarusCommandTest, Run_Profile_IsATable) {
  WriteText(scratch_.path() / "w.world", kGoNearWorld);
  const CommandResult result =
      Icarus({"run", "p.icarus", "--script", "w.world", "--profile"}, kGoNear);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("chosen  skill\n"), std::string::npos) << result.err;
}

TEST_F(IcarusCommandTest, Format_Diff_PrintsWhatWouldChange) {
  const CommandResult result =
      Icarus({"fmt", "--diff", "p.icarus"}, "(Go () :action ({go}))\n(Top ()\n:means ((Go)))\n");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out.find("--- p.icarus\n+++ p.icarus\n@@ -1,3 +1,"), 0U) << result.out;
  EXPECT_NE(result.out.find("\n-:means ((Go)))\n"), std::string::npos) << result.out;
  WriteText(scratch_.path() / "d.patch", result.out);
  const CommandResult good = Icarus({"fmt", "--diff", "p.icarus"}, kGood);
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_EQ(good.out, "");
}

CommandResult Repl(const std::filesystem::path& folder, const std::string& commands,
                   const std::string& program, const std::string& world = kGoNearWorld) {
  WriteText(folder / "p.icarus", program);
  WriteText(folder / "w.world", world);
  WriteText(folder / "commands", commands);
  return RunShell("latchwork icarus repl p.icarus --script w.world < commands", folder);
}

TEST_F(IcarusCommandTest, Repl_Session_GivesTheSameAnswersAgain) {
  const CommandResult result = Repl(
      scratch_.path(),
      "top\nwatch (car ?)\nstep\nmemory\nwhy\nwhy-not Go\nstep\nwhy-not Go\nanswer {range-to "
      "car1} 7\nstep 2\nbreak fact (seen ?)\nstore (seen it)\nmemory (seen ?)\nupdate (seen ?) "
      "(seen that)\nforget (car ?)\nmemory\nbreak\nquit\nstep\n",
      kGoNear);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            "(Near car1)\n"
            "1: start {go}\n"
            "+ (car car1)\n"
            "(car car1)\n"
            "{go}\n"
            "(Near car1)\n"
            "  objective False: (Distance car1 ?d) {< ?d 1.0}\n"
            "  means 1: (Go)  [3:11]\n"
            "(Go)\n"
            "sensor: {range-to car1} = 3.0\n"
            "(Go) was called and acted; the act chosen is {go}  [3:11]\n"
            "2: stop {go} True\n"
            "- (car car1)\n"
            "(Go) was not called\n"
            "  the way to it ends in (Near car1), whose means calls Go\n"
            "    its objective is not False, so that nothing else of it is asked\n"
            "3: (not called)\n"
            "4: start {go}\n"
            "(seen it)\n"
            "(seen that)\n"
            "1: fact (seen ?)\n");
}

TEST_F(IcarusCommandTest, Repl_WhyNot_NamesTheClauseAndWhatItFailedOn) {
  constexpr const char* kProgram =
      "(Top () :requires ((car ?c) (Ready ?c)) :means ((Ram ?c)))\n"
      "(Ready (?c) :objective ((driver ?c ?p fast) {awake ?p}))\n(Ram (?c) :action ({ram ?c}))\n";
  const CommandResult result =
      Repl(scratch_.path(),
           "step\nwhy-not Ram\nstep\nwhy-not Ram car1\nwhy-not Rams\nwhy-not\nbreak Ram\nanswer "
           "{awake ann} t\nrun\nwhy-not Ram\nwhy\n",
           kProgram,
           "(top (Top))\n(cycle (store (car car1)) (store (driver car1 ann slow)))\n"
           "(cycle (update (driver ? ? ?) (driver car1 ann fast)))\n");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            "1: False\n"
            "(Ram) was not called\n"
            "  the way to it ends in (Top), whose means calls Ram\n"
            "    requires: (Ready car1) is False  [1:29]\n"
            "      objective: (driver car1 ?p fast) is False; the nearest fact is (driver car1 ann "
            "slow)  [2:25]\n"
            "      it has no :means to act by\n"
            "2: False\n"
            "(Ram car1) was not called\n"
            "  the way to it ends in (Top), whose means calls Ram\n"
            "    requires: (Ready car1) is False  [1:29]\n"
            "      objective: {awake ann} is False: {awake ann} = nil  [2:45]\n"
            "      it has no :means to act by\n"
            "there is no skill 'Rams'; did you mean 'Ram'?\n"
            "why-not SKILL [ARGUMENT ..]\n"
            "3: start {ram car1}\n"
            "break: Ram\n"
            "(Ram car1) was called and acted; the act chosen is {ram car1}  [1:49]\n"
            "{ram car1}\n"
            "(Top)\n"
            "  held: (car car1)  [1:20]\n"
            "  held: (Ready car1)  [1:29]\n"
            "  means 1: (Ram car1)  [1:49]\n"
            "(Ram car1)\n"
            "sensor: {awake ann} = t\n");
}

TEST_F(IcarusCommandTest, Repl_AnyInput_IsSurvived) {
  std::string commands =
      "why\nwhy-not Near\nbreak act {\nbreak fact\nwatch ?x\nstore (\nstore (a)) "
      "(b\nanswer {f} \nanswer 3 4\ntop (Nera 1)\ntop )(\nstep -1\nrun x\ndelete 9\n"
      "trace maybe\nreload\nfoo\nsetp\n\n   \n";
  commands += std::string(100'000, '(') + "\n" + std::string("step\0\1\2\xff\n", 10) +
              "memory (((\nstep 2\ntrace\nhelp";
  const CommandResult result = Repl(scratch_.path(), commands, kGoNear);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("did you mean 'step'?"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("\n1: start {go}\n2: stop {go} True\n"), std::string::npos)
      << result.out;
}

TEST_F(IcarusCommandTest, Repl_Reload_KeepsMemoryOrTheOldProgram) {
  WriteText(scratch_.path() / "p.icarus", kGoNear);
  WriteText(scratch_.path() / "w.world", kGoNearWorld);
  WriteText(scratch_.path() / "bad.icarus", kBad);
  WriteText(scratch_.path() / "good.icarus", std::string(kGoNear) + "(Turn () :action ({turn}))\n");
  const CommandResult result = RunShell(
      "mkfifo commands && { latchwork icarus repl p.icarus --script w.world < commands > out & }\n"
      "exec 3> commands\n"
      "say() { echo \"$1\" >&3; until grep -q \"$2\" out; do :; done; }\n"
      "say step '^1:'; cp bad.icarus p.icarus; say reload 'goes on'; cp good.icarus p.icarus\n"
      "say reload skills; echo memory >&3; echo step >&3; exec 3>&-; wait; cat out",
      scratch_.path());
  EXPECT_EQ(result.out,
            "1: start {go}\nthe old program goes on\n4 skills\n(car car1)\n2: stop {go} True\n")
      << result.err;
  EXPECT_NE(result.err.find("p.icarus:1:8: error[I006]"), std::string::npos) << result.err;
}

TEST_F(IcarusCommandTest, Translate_TreesAndPlans_ActAsTheirExamplesSay) {
  const std::filesystem::path examples =
      std::filesystem::path(LATCHWORK_SOURCE_DIR) / "examples" / "icarus" / "plans";
  for (const char* file : {"collide.tree", "collide.plan"}) {
    const CommandResult program =
        RunLatchwork({"icarus", "translate", (examples / file).string()}, scratch_.path());
    ASSERT_EQ(program.exit_code, 0) << program.err;
    const CommandResult run =
        Icarus({"run", "p.icarus", "--script", (examples / "collide.world").string()}, program.out);
    EXPECT_EQ(run.exit_code, 0) << file << run.out << run.err;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 8);
  }
}

TEST_F(IcarusCommandTest, Translate_Mistakes_AreReported) {
  const CommandResult result =
      Icarus({"translate", "p.icarus"}, "(teleo-reactive Go () (when {far} to {go}))\n");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("p.icarus:1:23: error[I033]"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace latchwork::testing
