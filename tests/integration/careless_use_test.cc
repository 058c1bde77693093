// SPDX-License-Identifier: BSD-3-Clause
//
// What becomes of a command that is used carelessly: nothing is lost, and nothing bad looks good.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using ::testing::HasSubstr;

constexpr int kWrongUsage = 2;
constexpr int kInvalidInput = 3;
constexpr int kInternalError = 5;
const std::string kOffice = LATCHWORK_SOURCE_DIR "/examples/office/";
using Commands = std::vector<std::string>;
const std::string kProblem = LATCHWORK_SOURCE_DIR "/examples/tptp/way.p";

class CarelessUseTest : public ::testing::Test {
 protected:
  CommandResult Latchwork(const std::vector<std::string>& arguments) const {
    return RunLatchwork(arguments, folder_.path());
  }
  CommandResult Shell(const std::string& script) const { return RunShell(script, folder_.path()); }
  std::filesystem::path File(const std::string& name) const { return folder_.path() / name; }

  void ExpectWrongUsage(const std::vector<std::string>& arguments, const std::string& why) const {
    const CommandResult result = Latchwork(arguments);
    EXPECT_EQ(result.exit_code, kWrongUsage) << result.err;
    EXPECT_THAT(result.err, HasSubstr(why));
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(CarelessUseTest, NumbersThatAreNone_AreWrongUsage) {
  const std::string agent = kOffice + "scenario1.xml";
  ExpectWrongUsage({"run", agent, "--seed", "-1"}, "'-1' is not a whole number");
  ExpectWrongUsage({"run", agent, "--seed", "99999999999999999999"}, "is not a whole number");
  ExpectWrongUsage({"run", agent, "--ticks", "0"}, "'0' is not a whole number, 1 or more");
  ExpectWrongUsage({"run", agent, "--seeds", "0-18446744073709551615"}, "more than 1000000 runs");
  ExpectWrongUsage({"explain", agent, "--tick", "-1"}, "'-1' is not a whole number");
}

TEST_F(CarelessUseTest, AgentFilesOfOneName_DoNotShareAFolder) {
  const std::string agent = kOffice + "scenario1.xml";
  ExpectWrongUsage({"run", agent, agent, "--ticks", "3", "--out", "out"}, "'scenario1'");
  EXPECT_FALSE(std::filesystem::exists(File("out")));
}

TEST_F(CarelessUseTest, UnknownCommand_IsNamed) {
  ExpectWrongUsage({"chekc"}, "there is no command 'chekc'\n  did you mean 'check'?");
  ExpectWrongUsage({"icarus", "run"}, "see: latchwork icarus run --help");
}

TEST_F(CarelessUseTest, FullDisk_IsNoSuccess) {
  for (const std::string& command : Commands{"prove --proof " + kProblem, "plugin list"}) {
    const CommandResult result = Shell("latchwork " + command + " > /dev/full");
    EXPECT_EQ(result.exit_code, kInternalError) << command;
    EXPECT_THAT(result.err, HasSubstr("standard output cannot be written"));
  }
}

TEST_F(CarelessUseTest, ClosedInput_IsNoEmptyInput) {
  for (const std::string& command : Commands{"prove -", "check-proof " + kProblem, "icarus check -",
                                             "entail - --minimize p/1 --query 'p(a)'"}) {
    const CommandResult result = Shell("latchwork " + command + " <&-");
    EXPECT_EQ(result.exit_code, kInvalidInput) << command << '\n' << result.out;
    EXPECT_THAT(result.err, HasSubstr("standard input cannot be read")) << command;
  }
}

TEST_F(CarelessUseTest, InterruptedRun_KeepsWhatItHas) {
  const CommandResult result = Shell("latchwork run " + kOffice +
                                     "wander.xml --out out & "
                                     "until [ -e out/run.journal ]; do :; done; kill -INT $!; "
                                     "wait $!");
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.out, HasSubstr("stopped"));
  const auto summary = nlohmann::json::parse(ReadText(File("out/summary.json")));
  EXPECT_EQ(summary["outcome"], "stopped");
  EXPECT_EQ(Latchwork({"replay", "out/run.journal"}).exit_code, 0);
}

TEST_F(CarelessUseTest, FolderInUse_IsLeftAlone) {
  const CommandResult result =
      Shell("exec 9<.; flock 9; latchwork run " + kOffice + "scenario1.xml --ticks 3 --out .");
  EXPECT_EQ(result.exit_code, kWrongUsage) << result.err;
  EXPECT_THAT(result.err, HasSubstr("another run is writing to ."));
  EXPECT_FALSE(std::filesystem::exists(File("run.journal")));
}

TEST_F(CarelessUseTest, Check_ReadsWhatOnlyTheWorldUnderstands) {
  const CommandResult result =
      Latchwork({"check", kOffice + "scenario1.xml", "--set", "world.goal=r1_99"});
  EXPECT_EQ(result.exit_code, kInvalidInput);
  EXPECT_THAT(result.err, HasSubstr("the building has no landmark 'r1_99'"));
}

TEST_F(CarelessUseTest, Check_ReadsFragmentsOnTopOfAnAgent) {
  const CommandResult result =
      Latchwork({"check", kOffice + "scenario1.xml", "--scenario", kOffice + "icarus.xml"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(CarelessUseTest, Explain_TellsAnUnknownLayerFromATickWithoutDecision) {
  const std::string agent = kOffice + "scenario1.xml";
  ExpectWrongUsage({"explain", agent, "--layer", "nope"}, "there is no layer 'nope'");
  const CommandResult late = Latchwork({"explain", agent, "--tick", "9999999"});
  EXPECT_EQ(late.exit_code, 1);
  EXPECT_THAT(late.err, HasSubstr("there is no tick 9999999: the run ends after"));
}

}  // namespace
}  // namespace latchwork::testing
