// SPDX-License-Identifier: BSD-3-Clause
//
// What the command prints and with which code it exits, as scripts rely on it.
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

using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;

const std::string kExamples = LATCHWORK_SOURCE_DIR "/examples/office/";

std::vector<std::string> Keys(const nlohmann::json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

class CommandTest : public ::testing::Test {
 protected:
  CommandResult Latchwork(const std::vector<std::string>& arguments) const {
    return RunLatchwork(arguments, folder_.path());
  }
  nlohmann::json Json(const std::vector<std::string>& arguments, int exit_code = 0) const {
    const CommandResult result = Latchwork(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    return nlohmann::json::parse(result.out);
  }
  std::filesystem::path File(const std::string& name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

TEST_F(CommandTest, RunJson_HasTheDocumentedFields) {
  const nlohmann::json run =
      Json({"run", kExamples + "scenario1.xml", "--seed", "7", "--ticks", "20", "--json"}, 1);
  EXPECT_EQ(run.at("outcome"), "not reached");
  EXPECT_EQ(run.at("collisions"), 0);
  EXPECT_EQ(run.at("ticks"), 20);
  EXPECT_EQ(run.at("seed"), 7);
  ASSERT_EQ(run.at("layers").size(), 4U);
  const nlohmann::json& avoid = run.at("layers").front();
  EXPECT_EQ(avoid.at("name"), "avoid");
  EXPECT_EQ(avoid.at("reasoner"), "pttp");
  EXPECT_EQ(avoid.at("decisions"), 20);
  EXPECT_THAT(Keys(avoid.at("time_us")), ElementsAre("max", "mean", "p50", "p99", "sd"));
  EXPECT_THAT(Keys(avoid.at("inferences")), ElementsAre("mean", "sd"));
  EXPECT_THAT(Keys(avoid), IsSupersetOf({"budget_hits", "retracted", "faults"}));
}

TEST_F(CommandTest, RunJson_IsWhatTheSummaryHolds) {
  const nlohmann::json printed =
      Json({"run", kExamples + "scenario1.xml", "--ticks", "5", "--json", "--out", "out"}, 1);
  EXPECT_EQ(printed, nlohmann::json::parse(ReadText(File("out/summary.json"))));
}

TEST_F(CommandTest, RunOfSeveralSeeds_ListsThemInOrder) {
  const nlohmann::json runs = Json(
      {"run", kExamples + "scenario1.xml", "--seeds", "3-5", "-j", "2", "--ticks", "5", "--json"},
      1);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].at("seed"), 3);
  EXPECT_EQ(runs[1].at("seed"), 4);
  EXPECT_EQ(runs[2].at("seed"), 5);
}

TEST_F(CommandTest, Run_SaysTheCommandThatRepeatsIt) {
  const nlohmann::json run = Json({"run", kExamples + "scenario1.xml", "--seed", "3", "--ticks",
                                   "5", "--set", "world.people=0", "--json"},
                                  1);
  EXPECT_EQ(run.at("command"), "latchwork run " + kExamples +
                                   "scenario1.xml --seed 3 --ticks 5 --set 'world.people=0'");
}

class ReplayCommandTest : public CommandTest {
 protected:
  void SetUp() override {
    Latchwork({"run", kExamples + "scenario1.xml", "--ticks", "60", "--out", "out"});
  }
};

TEST_F(ReplayCommandTest, SameAgent_IsIdentical) {
  const CommandResult result = Latchwork({"replay", "out/run.journal"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "identical: 60 ticks\n");
}

TEST_F(ReplayCommandTest, OnSeveralThreads_IsIdentical) {
  EXPECT_EQ(Latchwork({"replay", "out/run.journal", "--threads", "4"}).exit_code, 0);
}

TEST_F(ReplayCommandTest, AnotherParameter_NamesTheFirstDifference) {
  const CommandResult result =
      Latchwork({"replay", "out/run.journal", "--set", "avoid.speed_gain=0.3"});
  EXPECT_EQ(result.exit_code, 6) << result.err;
  EXPECT_THAT(result.out, StartsWith("tick "));
  EXPECT_THAT(result.out, HasSubstr("layer avoid"));
}

TEST_F(ReplayCommandTest, CutJournal_IsReplayedUpToTheCut) {
  const std::string journal = ReadText(File("out/run.journal"));
  WriteText(File("cut.journal"), journal.substr(0, journal.size() - 1000));
  const CommandResult result = Latchwork({"replay", "cut.journal"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("after which the journal was cut"));
}

TEST_F(ReplayCommandTest, ForgedTick_IsRefused) {
  std::string journal = ReadText(File("out/run.journal"));
  const std::size_t place = journal.find("sonar_reading", journal.size() / 2);
  ASSERT_NE(place, std::string::npos);
  journal[place] = 'S';
  WriteText(File("forged.journal"), journal);
  const CommandResult result = Latchwork({"replay", "forged.journal"});
  EXPECT_EQ(result.exit_code, 3) << result.out;
  EXPECT_THAT(result.err, HasSubstr("forged.journal"));
}

TEST_F(ReplayCommandTest, MisspeltSetting_IsNotTakenForAnotherAgent) {
  const CommandResult result =
      Latchwork({"replay", "out/run.journal", "--set", "avoid.sped_gain=0.3"});
  EXPECT_EQ(result.exit_code, 3) << result.out;
  EXPECT_THAT(result.err, HasSubstr("sped_gain"));
  EXPECT_THAT(result.err, ::testing::Not(HasSubstr("--agent")));
}

TEST_F(ReplayCommandTest, SettingWithoutPart_IsWrongUsage) {
  const CommandResult result = Latchwork({"replay", "out/run.journal", "--set", "people=4"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("'people=4' is not PART.NAME=VALUE"));
}

TEST_F(CommandTest, PluginListJson_NamesEveryPluginOfTheAgent) {
  const nlohmann::json list = Json({"plugin", "list", "--json"});
  EXPECT_FALSE(list.at("folders").empty());
  std::vector<std::string> names;
  for (const nlohmann::json& plugin : list.at("plugins")) {
    EXPECT_THAT(Keys(plugin), ElementsAre("kind", "name", "path", "problem", "summary", "version"));
    EXPECT_EQ(plugin.at("problem"), "");
    names.push_back(plugin.at("kind").get<std::string>() + " " +
                    plugin.at("name").get<std::string>());
  }
  EXPECT_THAT(names, IsSupersetOf({"layer avoid", "layer seek", "layer elevators",
                                   "layer itinerary", "reasoner pttp", "world office"}));
}

TEST_F(CommandTest, PluginListJson_KeepsWhatCannotBeLoaded) {
  std::filesystem::create_directory(File("plugins"));
  WriteText(File("plugins/torn.so"), "no library");
  const nlohmann::json list = Json({"--plugin-path", "plugins", "plugin", "list", "--json"});
  const nlohmann::json& first = list.at("plugins").front();
  EXPECT_EQ(first.at("name"), "torn");
  EXPECT_EQ(first.at("kind"), "unknown");
  EXPECT_NE(first.at("problem"), "");
}

TEST_F(CommandTest, PluginShow_TellsPortsParametersAndAnExample) {
  const CommandResult result = Latchwork({"plugin", "show", "avoid"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, StartsWith("layer avoid "));
  for (const char* part :
       {"Inputs\n  sonar", "Outputs\n  motion (cannot be inhibited)", "  repulsion ",
        "  tptp, icarus\n", "<layer name=\"avoid\" plugin=\"avoid\""}) {
    EXPECT_THAT(result.out, HasSubstr(part));
  }
}

TEST_F(CommandTest, PluginShow_TellsTheEventsOfAWorld) {
  EXPECT_THAT(Latchwork({"plugin", "show", "office"}).out,
              HasSubstr("out_of_order(elevator: symbol)"));
}

TEST_F(CommandTest, Check_SumsUpEveryExample) {
  const CommandResult result = Latchwork(
      {"check", kExamples + "scenario1.xml", kExamples + "wander.xml", kExamples + "events.xml"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("scenario1.xml: ok: 4 layers"));
  EXPECT_THAT(result.out, HasSubstr("wander.xml: ok: 2 layers"));
  EXPECT_THAT(result.out, HasSubstr("4 events"));
}

TEST_F(CommandTest, CheckJson_ListsEveryMistakeWithItsPlace) {
  const std::string file = LATCHWORK_SOURCE_DIR "/tests/integration/bad_input/six_mistakes.xml";
  const nlohmann::json mistakes = Json({"check", "--json", file}, 4);
  ASSERT_EQ(mistakes.size(), 6U);
  for (const nlohmann::json& mistake : mistakes) {
    EXPECT_EQ(mistake.at("file"), file);
    EXPECT_GT(mistake.at("line"), 0);
    EXPECT_GT(mistake.at("column"), 0);
    EXPECT_NE(mistake.at("message"), "");
  }
  EXPECT_THAT(Json({"check", "--json", kExamples + "scenario1.xml"}), IsEmpty());
}

TEST_F(CommandTest, Version_IsTold) {
  EXPECT_THAT(Latchwork({"--version"}).out, StartsWith("latchwork "));
}

}  // namespace
}  // namespace latchwork::testing
