// SPDX-License-Identifier: BSD-3-Clause
//
// `latchwork icarus` as it is used: exit codes, and what goes to which stream.
#include <gtest/gtest.h>

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

constexpr const char* kNear =
    "(Near (?car)\n  :objective ((Distance ?car ?d) {< ?d 1.0})\n  :means ((Go)))\n"
    "(Distance (?car ?d) :sensor ((bind ?d {range-to ?car})))\n(Go () :action ({go}))\n";
constexpr const char* kApproach =
    "(top (Near car1))\n(cycle (answer {range-to car1} 3.0) (store (car car1)) (expect {go}))\n"
    "(cycle (answer {range-to car1} 0.5) (forget (car ?)) (expect true))\n(cycle (idle))\n";

TEST_F(IcarusCommandTest, Trace_Text_IsIndentedWithPlaces) {
  WriteText(scratch_.path() / "w.world", kApproach);
  const CommandResult result = Icarus({"trace", "p.icarus", "--script", "w.world"}, kNear);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out.find("cycle 1\n        (Near car1)\n2:15      (Distance car1 ?d)\n"), 0U)
      << result.out;
  EXPECT_NE(result.out.find("\n3:12    chosen {go}\n1: start {go}\ncycle 2\n"), std::string::npos)
      << result.out;
  const CommandResult skills =
      Icarus({"trace", "p.icarus", "--script", "w.world", "--level", "skill"}, kNear);
  EXPECT_EQ(skills.out.find("range-to"), std::string::npos) << skills.out;
}

TEST_F(IcarusCommandTest, Trace_Replayed_IsIdenticalOrNamesTheFirstDifference) {
  WriteText(scratch_.path() / "w.world", kApproach);
  const CommandResult trace =
      Icarus({"trace", "p.icarus", "--script", "w.world", "--json", "--acts", "all"}, kNear);
  ASSERT_EQ(trace.exit_code, 0) << trace.err;
  WriteText(scratch_.path() / "t.jsonl", trace.out);
  const std::vector<std::string> replay = {"trace", "--replay", "t.jsonl", "p.icarus"};
  const CommandResult same = Icarus(replay, "; The same.\n" + std::string(kNear));
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  EXPECT_EQ(same.out.find("identical: 3 cycles, "), 0U) << same.out;
  std::string changed = kNear;
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
    const CommandResult result = Icarus(replay, kNear);
    EXPECT_EQ(result.exit_code, 3) << text;
    EXPECT_EQ(result.err.find("t.jsonl:1: error: "), 0U) << result.err;
  }
  EXPECT_EQ(Icarus({"trace", "p.icarus"}, kNear).exit_code, 2);
}

TEST_F(IcarusCommandTest, Run_FaultModes_EndTheCycleOrTheRun) {
  WriteText(scratch_.path() / "w.world",
            "(top (Near car1)) (functions range-to)\n(cycle (answer {range-to car1} far))\n"
            "(cycle (answer {range-to car1} 3))\n");
  const std::vector<std::string> run = {"run", "p.icarus", "--script", "w.world", "--faults"};
  const auto with = [&](const char* mode) {
    std::vector<std::string> arguments = run;
    arguments.emplace_back(mode);
    return Icarus(arguments, kNear);
  };
  EXPECT_EQ(with("false").out, "1: start {go}\n2: continue {go}\n");
  EXPECT_EQ(with("abort-cycle").out, "1: aborted\n2: start {go}\n");
  const CommandResult stopped = with("stop");
  EXPECT_EQ(stopped.out, "1: aborted\n");
  EXPECT_EQ(stopped.exit_code, 1);
}

TEST_F(IcarusCommandTest, Run_Profile_IsATable) {
  WriteText(scratch_.path() / "w.world", kApproach);
  const CommandResult result =
      Icarus({"run", "p.icarus", "--script", "w.world", "--profile"}, kNear);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("chosen  skill\n"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace latchwork::testing
