// SPDX-License-Identifier: BSD-3-Clause
//
// Plugins that misbehave in one way each, in a real run: the robot stops safely or goes on as
// declared, and the report says which plugin, what and when.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kFaultPlugins = LATCHWORK_BINARY_DIR "/fault_plugins";

/// The far scenario with another reasoner in one layer.
std::string AgentWith(const std::string& layer, const std::string& reasoner) {
  return "<agent format=\"1\" name=\"faulty\" tick=\"100ms\" duration=\"60s\">\n"
         "  <include file=\"" LATCHWORK_SOURCE_DIR
         "/examples/office/office.xml\"/>\n"
         "  <override part=\"world\"><param name=\"start\" value=\"r1_03\"/>"
         "<param name=\"goal\" value=\"r3_18\"/></override>\n"
         "  <override part=\"" +
         layer + "\">" + reasoner +
         "</override>\n"
         "</agent>\n";
}

struct Faulty {
  CommandResult command;
  nlohmann::json summary;
};

Faulty RunWith(const std::string& layer, const std::string& reasoner,
               const std::string& ticks = "60") {
  const TemporaryFolder folder;
  WriteText(folder.path() / "agent.xml", AgentWith(layer, reasoner));
  Faulty faulty;
  faulty.command = RunLatchwork(
      {"--plugin-path", kFaultPlugins, "run", "agent.xml", "--ticks", ticks, "--out", "out"},
      folder.path());
  faulty.summary =
      nlohmann::json::parse(ReadText(folder.path() / "out/summary.json"), nullptr, false);
  return faulty;
}

void ExpectContained(const Faulty& faulty, const std::string& layer, const std::string& what) {
  EXPECT_EQ(faulty.command.exit_code, 1) << faulty.command.err;
  EXPECT_THAT(faulty.command.out, HasSubstr("in layer " + layer + " (plugin "));
  EXPECT_THAT(faulty.command.out, HasSubstr(what));
  ASSERT_FALSE(faulty.summary.is_discarded());
  EXPECT_EQ(faulty.summary.at("collisions"), 0);
}

TEST(FaultsTest, ThrowingReasonerOfLayer0StopsTheRobot) {
  const Faulty faulty = RunWith(
      "avoid", R"(<reasoner plugin="throws"><param name="from_call" value="20"/></reasoner>)");
  ExpectContained(faulty, "avoid",
                  "fault at tick 20 in layer avoid (plugin throws): exception: thrown on purpose");
  EXPECT_EQ(faulty.summary.at("layers").at(0).at("faults"), 40);
}

TEST(FaultsTest, ThrownIntIsContained) {
  ExpectContained(
      RunWith("seek", R"(<reasoner plugin="throws"><param name="thrown" value="int"/></reasoner>)"),
      "seek", "(plugin throws): exception");
}

TEST(FaultsTest, NanNeverReachesTheWheels) {
  ExpectContained(RunWith("avoid", R"(<reasoner plugin="returns_nan"/>)"), "avoid",
                  "fault at tick 5 in layer avoid (plugin returns_nan): bad conclusion");
}

TEST(FaultsTest, OverspentBudgetIsAFault) {
  ExpectContained(RunWith("elevators", R"(<reasoner plugin="over_budget"/>)"), "elevators",
                  "(plugin over_budget): over budget");
}

TEST(FaultsTest, InconsistencyIsAFault) {
  ExpectContained(RunWith("itinerary", R"(<reasoner plugin="inconsistent"/>)", "120"), "itinerary",
                  "(plugin inconsistent): inconsistent");
}

TEST(FaultsTest, FactsOutsideTheContractAreAFault) {
  ExpectContained(RunWith("seek", R"(<reasoner plugin="bad_facts"/>)"), "seek",
                  "(plugin bad_facts): bad conclusion");
}

TEST(FaultsTest, DeclaredFallbackIsSaidInsteadOfTheLayersOwn) {
  const Faulty faulty = RunWith(
      "avoid",
      R"(<reasoner plugin="throws"/><fallback><fact port="motion">turn(0.3)</fact></fallback>)");
  ExpectContained(faulty, "avoid", "(plugin throws): exception");
}

TEST(FaultsTest, WrongAbiIsRefusedBeforeItRuns) {
  const TemporaryFolder folder;
  WriteText(folder.path() / "agent.xml", AgentWith("seek", R"(<reasoner plugin="wrong_abi"/>)"));
  const CommandResult result =
      RunLatchwork({"--plugin-path", kFaultPlugins, "run", "agent.xml"}, folder.path());
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err,
              AllOf(HasSubstr("agent.xml:4:"), HasSubstr("wrong_abi.so"), HasSubstr("ABI")));
}

TEST(FaultsTest, TruncatedPluginIsRefusedWithItsReason) {
  const TemporaryFolder folder;
  const std::filesystem::path plugin = folder.path() / "throws.so";
  std::filesystem::copy_file(kFaultPlugins + "/throws.so", plugin);
  std::filesystem::resize_file(plugin, std::filesystem::file_size(plugin) / 2);
  WriteText(folder.path() / "agent.xml", AgentWith("seek", R"(<reasoner plugin="throws"/>)"));
  const CommandResult result =
      RunLatchwork({"--plugin-path", folder.path().string(), "run", "agent.xml"}, folder.path());
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err, AllOf(HasSubstr("throws"), HasSubstr("truncated")));
}

}  // namespace
}  // namespace latchwork::testing
