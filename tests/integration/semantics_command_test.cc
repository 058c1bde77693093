// SPDX-License-Identifier: BSD-3-Clause
//
// `latchwork semantics` as it is used: exit codes, and what it prints where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using test::TemporaryFolder;
using ::testing::EndsWith;
using ::testing::HasSubstr;

constexpr const char* kDisjunction =
    "p lay 2 6\nL 1\nP 1 1 2 3 0\n-1 3 0\n-2 3 0\nB 5 1\nB 6 2\nL 2\nP 1 4 5 6 0\n-4 5 6 0\n"
    "F 4 0\n? slow c 3 0\n? not_slow c -3 0\n";

class SemanticsCommandTest : public ::testing::Test {
 protected:
  CommandResult Semantics(const std::string& text, std::vector<std::string> options = {}) {
    WriteText(scratch_.path() / "a.lay", text);
    options.insert(options.begin(), {"semantics", "a.lay"});
    return RunLatchwork(options, scratch_.path());
  }

  TemporaryFolder scratch_;
};

TEST_F(SemanticsCommandTest, Difference_ExitsWithSixAndEndsWithTheAnswers) {
  const CommandResult result = Semantics(kDisjunction);
  EXPECT_EQ(result.exit_code, 6);
  EXPECT_THAT(result.out, EndsWith("\n\ns slow no\ns not_slow yes\no slow no\no not_slow no\n"
                                   "r slow yes\nr not_slow no\n= slow yes\n= not_slow no\n"));
  EXPECT_THAT(result.out, HasSubstr("transfer single is unsound on not_slow"));
  EXPECT_EQ(result.err, "");
}

TEST_F(SemanticsCommandTest, Transfer_PrintsAnswersOfThatOneOnly) {
  const CommandResult refined = Semantics(kDisjunction, {"--transfer", "refined"});
  EXPECT_EQ(refined.exit_code, 0);
  EXPECT_THAT(refined.out, EndsWith("\n\nslow yes\nnot_slow no\n"));
  EXPECT_EQ(Semantics(kDisjunction, {"--transfer", "open"}).exit_code, 6);
}

TEST_F(SemanticsCommandTest, Json_HoldsConditionsAnswersAndTheCounterExample) {
  const CommandResult result = Semantics(kDisjunction, {"--json"});
  EXPECT_EQ(result.exit_code, 6);
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["goals_decided"], false);
  EXPECT_EQ(json["consistent_with_transfers"], "yes");
  EXPECT_EQ(json["answers"][1]["single"], "yes");
  EXPECT_EQ(json["answers"][1]["definition"], "no");
  EXPECT_EQ(json["counterexample"]["fault"], "unsound");
  // The counter-example is a theory itself, and shows the difference again.
  const CommandResult again = Semantics(json["counterexample"]["theory"], {"--transfer", "single"});
  EXPECT_EQ(again.exit_code, 6);
}

TEST_F(SemanticsCommandTest, LayerWithoutModel_IsNamedWithItsCore) {
  const CommandResult result =
      Semantics("p lay 2 3\nL 1\nP 1 1 0\nB 2 1\nL 2\nP 1 2 3 0\n-2 3 0\nF 2 -3 0\n? q c 1 0\n");
  EXPECT_EQ(result.exit_code, 6) << "by Definition 1 everything follows";
  EXPECT_THAT(result.out, HasSubstr("layer 2 contradicts itself, and hands nothing down"));
  EXPECT_THAT(result.out, HasSubstr("there is no layered model"));
}

TEST_F(SemanticsCommandTest, Budget_LeavesUnknown) {
  const CommandResult result = Semantics(kDisjunction, {"--transfer", "refined", "--states", "1"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, EndsWith("slow unknown\nnot_slow unknown\n"));
}

TEST_F(SemanticsCommandTest, BadFile_ShowsAllErrors) {
  const CommandResult result =
      Semantics("p lay 2 2\nL 1\nP 1 1 0\nB 1 1\nL 2\nP 1 2 0\n1 0\nB 1 1\n");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("a.lay:4:3: error: atom 1 is of layer 1, not of layer 2"));
  EXPECT_THAT(result.err, HasSubstr("a.lay:7:1: error: atom 1 is of layer 1, not of layer 2"));
  EXPECT_THAT(result.err, HasSubstr("a.lay:8:1: error: there is no layer above the highest"));
  EXPECT_EQ(result.out, "");
}

CommandResult OfSectors(std::vector<std::string> options) {
  options.insert(options.begin(), {"--plugin-path", LATCHWORK_BINARY_DIR "/example_plugins",
                                   "semantics", "examples/sectors/sectors.xml"});
  return RunLatchwork(options, LATCHWORK_SOURCE_DIR);
}

TEST(SemanticsOfAgentsTest, FiniteLayers_AreComparedWithDefinitionOne) {
  const CommandResult left =
      OfSectors({"--fact", "pusher: move_cmd(left)", "--transfer", "single"});
  EXPECT_EQ(left.exit_code, 0) << left.err;
  EXPECT_THAT(left.out, HasSubstr("layer 2 (pusher): pushed(s3) is proved"));
  EXPECT_THAT(left.out, HasSubstr("\ngo(s3) no\n~go(s3) yes\n"));
  EXPECT_THAT(left.out, HasSubstr("\ngo(s5) yes\n~go(s5) no\n"));
  const CommandResult corner = OfSectors({"--fact", "pusher: move_cmd(corner)"});
  EXPECT_EQ(corner.exit_code, 6) << corner.err;
  EXPECT_THAT(corner.out, HasSubstr("transfer single is unsound on go(s3)"));
  EXPECT_THAT(corner.out, HasSubstr("refined  the same on all 4 queries"));
}

TEST(SemanticsOfAgentsTest, BadFacts_AreAllRefused) {
  const CommandResult result = OfSectors(
      {"--fact", "pushr: move_cmd(left)", "--fact", "move_cmd", "--fact", "pusher: move_cmd(X)"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("did you mean 'pusher'?"));
  EXPECT_THAT(result.err, HasSubstr("not of the form LAYER: ATOM"));
  EXPECT_THAT(result.err, HasSubstr("what follows the layer is no ground atom"));
}

TEST(SemanticsOfAgentsTest, OtherLayers_AreRefusedEachWithItsPlaces) {
  const CommandResult result =
      RunLatchwork({"semantics", "examples/office/scenario1.xml"}, LATCHWORK_SOURCE_DIR);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("layer 'avoid' is no finite theory"));
  EXPECT_THAT(result.err, HasSubstr("layer 'seek' is no finite theory: 'destination' calls the "
                                    "attachment bearing/7"));
  EXPECT_THAT(result.err, HasSubstr("layer 'elevators' is no finite theory"));
  EXPECT_THAT(result.err, HasSubstr("seek.p:"));
}

TEST_F(SemanticsCommandTest, BudgetThatRanOut_IsNotAgreement) {
  const CommandResult result = Semantics(kDisjunction, {"--transfer", "refined", "--states", "1"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("not decided: 2 of 2 queries"));
  EXPECT_THAT(result.out, ::testing::Not(HasSubstr("the same on all")));
}

}  // namespace
}  // namespace latchwork::testing
