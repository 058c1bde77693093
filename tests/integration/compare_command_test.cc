// SPDX-License-Identifier: BSD-3-Clause
//
// `latchwork compare` as it is used: whole experiments, their shards, what interrupts them, and
// what is wrong with their files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/integration/towers.h"

namespace latchwork::testing {
namespace {

using ::testing::HasSubstr;

class CompareCommandTest : public TowersTest {};

TEST_F(CompareCommandTest, SameAgentTwiceAndAHandicap_NothingAndTheHandicapAreFound) {
  WriteText(scratch_.path() / "towers.xml", Experiment("seeds=\"1-12\""));
  const CommandResult result = Compare({"--out", "all", "-j", "2"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out,
              HasSubstr("towers: Against steady, slipping is slower in tower. No difference from "
                        "steady is shown for same.\n"));
  EXPECT_THAT(ReadText(scratch_.path() / "all/report.html"), HasSubstr("slipping is slower"));
  EXPECT_EQ(CountLines("all/runs.csv"), 1U + 36U);
  EXPECT_EQ(ReadText(scratch_.path() / "all/report.txt"), result.out);
}

TEST_F(CompareCommandTest, Controls_BehaveWithFewerSeeds) {
  std::string controls = ReadText(LATCHWORK_SOURCE_DIR "/examples/compare/controls.xml");
  const auto replace = [&](const std::string& what, const std::string& by) {
    const std::size_t at = controls.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    controls.replace(at, what.size(), by);
  };
  replace("1-30", "1-8");
  replace("../office", LATCHWORK_SOURCE_DIR "/examples/office");
  WriteText(scratch_.path() / "towers.xml", controls);
  const CommandResult result = Compare({"--out", "controls", "-j", "2"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out,
              HasSubstr("controls: Against pttp, slow is slower in next_door. No difference from "
                        "pttp is shown for same.\n"));
  EXPECT_THAT(result.out, ::testing::Not(HasSubstr("the same with every seed")))
      << "the control meets other worlds";
  EXPECT_THAT(ReadText(scratch_.path() / "controls/report.html"), HasSubstr("id=\"trajectories\""));
}

TEST_F(CompareCommandTest, Shards_GiveTheSameBytesWhateverTheirNumber) {
  WriteText(scratch_.path() / "towers.xml", Experiment("seeds=\"1-4\""));
  ASSERT_EQ(Compare({"--out", "all"}).exit_code, 0);
  for (const std::size_t count : {2U, 4U}) {
    std::vector<std::string> merge = {"--out", "merged" + std::to_string(count)};
    for (std::size_t index = count; index >= 1; --index) {
      const std::string shard = std::to_string(index) + "/" + std::to_string(count);
      const std::string out = "part" + std::to_string(count) + std::to_string(index);
      ASSERT_EQ(Compare({"--shard", shard, "--out", out}).exit_code, 0);
      EXPECT_EQ(CountLines(out + "/runs.jsonl"), 12 / count);
      merge.insert(merge.end(), {"--merge", out, "--merge", out});
    }
    ASSERT_EQ(Compare(merge).exit_code, 0);
    EXPECT_EQ(Bytes("merged" + std::to_string(count)), Bytes("all"));
  }
}

TEST_F(CompareCommandTest, TornLog_GoesOnWhereItWasCut) {
  WriteText(scratch_.path() / "towers.xml", Experiment("seeds=\"1-3\""));
  ASSERT_EQ(Compare({"--out", "all"}).exit_code, 0);
  const std::string whole = Bytes("all");
  const std::string log = ReadText(scratch_.path() / "all/runs.jsonl");
  WriteText(scratch_.path() / "all/runs.jsonl", log.substr(0, log.size() / 2));
  ASSERT_EQ(Compare({"--out", "all"}).exit_code, 0);
  EXPECT_EQ(Bytes("all"), whole);
  EXPECT_EQ(CountLines("all/runs.jsonl"), 9U);
}

TEST_F(CompareCommandTest, Interrupted_KeepsWhatIsDoneAndGoesOn) {
  WriteText(scratch_.path() / "towers.xml", Experiment("seeds=\"1-10\""));
  const CommandResult cut = RunShell(
      "latchwork compare towers.xml --quiet --out all & pid=$!\n"
      "until [ -s all/runs.jsonl ]; do :; done\n"
      "kill -INT $pid; wait $pid",
      scratch_.path());
  EXPECT_EQ(cut.exit_code, 1);
  EXPECT_THAT(cut.err, HasSubstr("the same command goes on from here"));
  const std::size_t done = CountLines("all/runs.jsonl");
  EXPECT_GE(done, 1U);
  ASSERT_LT(done, 30U);
  ASSERT_EQ(Compare({"--out", "all"}).exit_code, 0);
  ASSERT_EQ(Compare({"--out", "once", "-j", "2"}).exit_code, 0);
  EXPECT_EQ(Bytes("all"), Bytes("once"));
}

TEST_F(CompareCommandTest, RunThatCannotBegin_EndsTheExperimentAndIsNotKept) {
  std::string text = Experiment("seeds=\"1-2\"");
  text.replace(text.find("world.slip"), 10, "world.slop");
  WriteText(scratch_.path() / "towers.xml", text);
  const CommandResult result = Compare({"--out", "all"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("towers.xml:"));
  EXPECT_THAT(result.err, HasSubstr("slop"));
  EXPECT_EQ(ReadText(scratch_.path() / "all/runs.jsonl").find("slipping"), std::string::npos);
}

TEST_F(CompareCommandTest, FolderOfAnotherExperiment_IsLeftAlone) {
  WriteText(scratch_.path() / "towers.xml", Experiment("seeds=\"1-2\""));
  ASSERT_EQ(Compare({"--out", "all"}).exit_code, 0);
  const std::string before = Bytes("all");
  WriteText(scratch_.path() / "towers.xml", Experiment("seeds=\"2-3\""));
  const CommandResult result = Compare({"--out", "all"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("holds a run that is not of this experiment"));
  EXPECT_EQ(Bytes("all"), before);
}

TEST_F(CompareCommandTest, WrongFile_SaysEverythingAtOnceWithItsPlace) {
  WriteText(scratch_.path() / "towers.xml",
            "<experiment format=\"1\" name=\"towers\" seeds=\"9-3\">\n"
            "  <scenario name=\"a\" file=\"no.xml\"/>\n"
            "  <scenario name=\"a\" file=\"towers.xml\"/>\n"
            "  <agent name=\"x\" fragment=\"none.xml\"/>\n"
            "</experiment>\n");
  const CommandResult result = Compare({});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("towers.xml:1:45: "));
  EXPECT_THAT(result.err, HasSubstr("the last seed comes before the first"));
  EXPECT_THAT(result.err, HasSubstr("towers.xml:2:28: "));
  EXPECT_THAT(result.err, HasSubstr("towers.xml:3:19: "));
  EXPECT_THAT(result.err, HasSubstr("towers.xml:4:29: "));
  EXPECT_THAT(result.err, HasSubstr("a comparison needs two <agent> or more"));
}

TEST_F(CompareCommandTest, WrongShard_IsWrongUsage) {
  WriteText(scratch_.path() / "towers.xml", Experiment("seeds=\"1-2\""));
  for (const char* shard : {"3/2", "0/2", "1", "1/2x", "a/b"}) {
    EXPECT_EQ(Compare({"--shard", shard}).exit_code, 2) << shard;
  }
}

TEST_F(CompareCommandTest, Plan_SaysHowManyRunsAndSeeds) {
  WriteText(scratch_.path() / "towers.xml", Experiment("seeds=\"1-30\""));
  const CommandResult result = Compare({"--plan"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("1 scenarios x 3 agents x 30 seeds = 90 runs"));
  EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "out"));
}

}  // namespace
}  // namespace latchwork::testing
