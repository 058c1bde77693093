// SPDX-License-Identifier: BSD-3-Clause
//
// The process that `latchwork compare` starts its runs from: whatever a run does, and whoever is
// killed, the runs are counted as what they are, and nothing is left behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "tests/integration/run_command.h"
#include "tests/integration/towers.h"

namespace latchwork::testing {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

constexpr const char* kFaulty = "latchwork --plugin-path " LATCHWORK_BINARY_DIR "/fault_plugins ";

/// Says when a process is gone, or was ended and is still to be waited for by others.
constexpr const char* kGone =
    "gone() { ! [ -e /proc/$1 ] || grep -qs '^State:.*Z' /proc/$1/status; }\n"
    "children() { cat /proc/$1/task/*/children 2>/dev/null; }\n";

class ForkServerCommandTest : public TowersTest {
 protected:
  /// An experiment in which the player is played by one of the plugins that misbehave.
  void WriteFaulty(const std::string& attributes,
                   std::initializer_list<std::pair<std::string, std::string>> reasoners) const {
    std::string agents;
    for (const auto& [name, reasoner] : reasoners) {
      WriteText(scratch_.path() / (name + ".xml"),
                "<fragment format=\"1\"><override part=\"player\">" + reasoner +
                    "</override></fragment>\n");
      agents += "<agent name=\"" + name + "\" fragment=\"" + name + ".xml\"/>";
    }
    std::string text = Experiment(attributes);
    text.insert(text.find("<agent name=\"same\""), agents);
    WriteText(scratch_.path() / "towers.xml", text);
  }
  /// The last line of the log for this agent.
  Json Record(const std::string& agent) const {
    std::istringstream log(ReadText(scratch_.path() / "all/runs.jsonl"));
    Json record;
    for (std::string line; std::getline(log, line);) {
      Json each = Json::parse(line);
      if (each.at("agent") == agent) record = std::move(each);
    }
    return record;
  }
  CommandResult CompareFaulty(const std::string& more = "") const {
    return RunShell(kFaulty + ("compare towers.xml --quiet --out all " + more), scratch_.path());
  }
};

std::string Ends(const std::string& what) {
  return R"(<reasoner plugin="ends"><param name="what" value=")" + what + R"("/></reasoner>)";
}

TEST_F(ForkServerCommandTest, WhateverARunDoes_IsItsOutcomeAndNoneOfTheOthers) {
  WriteFaulty("seeds=\"1-2\"", {{"crash", Ends("process")},
                                {"killer", Ends("parent")},
                                {"loading", R"(<reasoner plugin="ends_on_loading"/>)"}});
  const CommandResult result = CompareFaulty();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(CountLines("all/runs.jsonl"), 12U);
  EXPECT_EQ(Record("crash").at("outcome"), "crashed");
  EXPECT_EQ(Record("crash").at("message"), "ended by signal 6");
  EXPECT_EQ(Record("killer").at("outcome"), "crashed");
  EXPECT_EQ(Record("killer").at("message"), "the fork server was ended by signal 9");
  EXPECT_EQ(Record("loading").at("outcome"), "crashed");
  for (const char* agent : {"steady", "same"}) {
    EXPECT_EQ(Record(agent).at("outcome"), "reached") << agent;
  }
  EXPECT_EQ(Record("steady").at("measures"), Record("same").at("measures"));
}

TEST_F(ForkServerCommandTest, RunThatNeverEnds_TimesOutAndTheNextIsMade) {
  WriteFaulty("seeds=\"1-1\" wall=\"3s\"", {{"endless", Ends("nothing")}});
  EXPECT_EQ(CompareFaulty().exit_code, 0);
  EXPECT_EQ(Record("endless").at("outcome"), "timed out");
  EXPECT_EQ(Record("slipping").at("seed"), 1);
}

TEST_F(ForkServerCommandTest, CommandOfARun_RepeatsIt) {
  WriteFaulty("seeds=\"1-3\"", {{"crash", Ends("process")}});
  ASSERT_EQ(CompareFaulty().exit_code, 0);
  const Json kept = Record("slipping");
  const std::string command = kept.at("command").get<std::string>();
  const Json again = Json::parse(RunShell(command + " --json --quiet", scratch_.path()).out);
  EXPECT_EQ(again.at("measures").at("time_s"), kept.at("measures").at("time_s"));
  EXPECT_EQ(again.at("outcome"), kept.at("outcome"));
  const std::string crash = Record("crash").at("command").get<std::string>();
  const CommandResult crashed =
      RunShell(kFaulty + crash.substr(crash.find(' ')) + " --quiet & wait $!", scratch_.path());
  EXPECT_EQ(crashed.exit_code, 128 + 6);
}

TEST_F(ForkServerCommandTest, LibraryThatStartsAThread_IsLeftToTheRuns) {
  WriteFaulty("seeds=\"1-4\"", {{"idler", R"(<reasoner plugin="starts_a_thread"/>)"}});
  const CommandResult result = CompareFaulty();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(CountLines("all/runs.jsonl"), 16U);
  const Json kept = Record("idler");
  const std::string command = kept.at("command").get<std::string>();
  const CommandResult again =
      RunShell(kFaulty + command.substr(command.find(' ')) + " --json --quiet", scratch_.path());
  EXPECT_EQ(Json::parse(again.out).at("measures").at("time_s"), kept.at("measures").at("time_s"));
}

TEST_F(ForkServerCommandTest, Killed_LeavesNothingBehind) {
  for (const char* signal : {"KILL", "INT"}) {
    WriteFaulty("seeds=\"1-9\"", {{"endless", Ends("nothing")}});
    const CommandResult result =
        RunShell(std::string(kGone) + kFaulty + "compare towers.xml --quiet --out " + signal +
                     " & harness=$!\n"
                     "until [ -s " +
                     signal +
                     "/runs.jsonl ]; do gone $harness && exit 9; done\n"
                     "until run=$(children $(children $harness)) && [ -n \"$run\" ]; do\n"
                     "  gone $harness && exit 9\n"
                     "done\n"
                     "server=$(children $harness)\n"
                     "kill -" +
                     signal +
                     " $harness; wait $harness; code=$?\n"
                     "until gone $server; do :; done\n"
                     "until gone $run; do :; done\n"
                     "exit $code",
                 scratch_.path());
    EXPECT_EQ(result.exit_code, signal == std::string("INT") ? 1 : 128 + 9) << result.err;
  }
}

TEST_F(ForkServerCommandTest, WhatIsNoTask_IsWrongUsage) {
  const CommandResult none = RunShell("latchwork fork-server </dev/null", scratch_.path());
  EXPECT_EQ(none.exit_code, 0);
  EXPECT_EQ(none.out, "ready\n");
  const CommandResult nonsense = RunShell("echo nonsense | latchwork fork-server", scratch_.path());
  EXPECT_EQ(nonsense.exit_code, 2);
  EXPECT_THAT(nonsense.err, HasSubstr("fork-server reads tasks of latchwork compare"));
}

}  // namespace
}  // namespace latchwork::testing
