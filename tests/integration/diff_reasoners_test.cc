// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using nlohmann::json;
using test::TemporaryFolder;

/// What is not installed is left out with a word.
TEST(DiffReasonersTest, RandomTheories_AllAgree) {
  const TemporaryFolder folder;
  const auto result =
      RunLatchwork({"diff-reasoners", "--random", "25", "--seed", "7", "--json", "--quiet",
                    "--reasoners", "pttp,circumscription:mode=bounded,eprover,swipl"},
                   folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report.at("theories"), 25);
  EXPECT_TRUE(report.at("disagreements").empty());
  EXPECT_LE(report.at("undecided").at("pttp"), 5);
}

TEST(DiffReasonersTest, APlantedBug_IsFoundAndShrunk) {
  const TemporaryFolder folder;
  const auto result =
      RunLatchwork({"--plugin-path", LATCHWORK_BINARY_DIR "/fault_plugins", "diff-reasoners",
                    "--random", "40", "--json", "--quiet", "--reasoners", "pttp,forgetful"},
                   folder.path());
  EXPECT_EQ(result.exit_code, 6) << result.err;
  const json report = json::parse(result.out);
  ASSERT_FALSE(report.at("disagreements").empty());
  for (const json& found : report.at("disagreements")) {
    EXPECT_LE(found.at("clauses"), 3) << found;
    const auto proved = RunLatchwork({"prove", found.at("file").get<std::string>()}, folder.path());
    EXPECT_THAT(proved.out, ::testing::HasSubstr("SZS status"));
    EXPECT_NE(proved.exit_code, 3) << proved.err;
  }
}

/// The decisions of an example's first ticks, made anew by these reasoners.
CommandResult CompareRecorded(const std::string& example, const std::string& ticks,
                              const std::string& reasoners, bool as_json = false) {
  const TemporaryFolder folder;
  const std::string agent = LATCHWORK_SOURCE_DIR "/examples/" + example;
  RunLatchwork({"run", agent, "--ticks", ticks, "--out", "out", "--quiet"}, folder.path());
  std::vector<std::string> words = {"diff-reasoners", "--journal",   "out/run.journal",
                                    "--quiet",        "--reasoners", reasoners};
  if (as_json) words.emplace_back("--json");
  return RunLatchwork(words, folder.path());
}

TEST(DiffReasonersTest, Journal_TheSameLatchesForAll) {
  const auto result = CompareRecorded("office/scenario1.xml", "40", "pttp,circumscription", true);
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_GT(json::parse(result.out).at("decisions"), 60);
}

TEST(DiffReasonersTest, JournalWithoutTheories_SaysThatNothingCouldBeCompared) {
  const auto result = CompareRecorded("icarus/cart_pole.xml", "5", "pttp,circumscription");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, ::testing::HasSubstr("its body is in icarus, not a theory"));
  EXPECT_THAT(result.err, ::testing::HasSubstr("nothing of out/run.journal could be compared"));
}

TEST(DiffReasonersTest, Journal_CountsWhatWasNotDecided) {
  const auto result = CompareRecorded("office/scenario1.xml", "4", "pttp,pttp:unique_names=true");
  EXPECT_THAT(result.out, ::testing::HasSubstr("not decided within the budget: "));
  EXPECT_THAT(result.out, ::testing::Not(::testing::HasSubstr(":  ")));
}

TEST(DiffReasonersTest, NothingToCompare_IsWrongUsage) {
  const TemporaryFolder folder;
  EXPECT_EQ(RunLatchwork({"diff-reasoners"}, folder.path()).exit_code, 2);
  EXPECT_EQ(
      RunLatchwork({"diff-reasoners", "--random", "1", "--reasoners", "pttp,nobody"}, folder.path())
          .exit_code,
      4);
}

TEST(DiffReasonersTest, AMisspeltParameter_IsInvalidInput) {
  const TemporaryFolder folder;
  const auto result = RunLatchwork({"diff-reasoners", "--random", "1", "--reasoners",
                                    "pttp:nope=1,circumscription,circumscription:mode=bounded"},
                                   folder.path());
  EXPECT_EQ(result.exit_code, 3) << result.out;
  EXPECT_THAT(result.err, ::testing::HasSubstr("nope"));
  EXPECT_EQ(result.out, "");
}

TEST(DiffReasonersTest, AFolderThatCannotBe_IsRefusedBeforeAnythingIsCompared) {
  const TemporaryFolder folder;
  const auto result = RunLatchwork(
      {"diff-reasoners", "--random", "1", "--out", "/dev/null/x", "--quiet"}, folder.path());
  EXPECT_EQ(result.exit_code, 2) << result.out;
  EXPECT_THAT(result.err, ::testing::HasSubstr("/dev/null/x"));
  EXPECT_EQ(result.out, "");
}

}  // namespace
}  // namespace latchwork::testing
