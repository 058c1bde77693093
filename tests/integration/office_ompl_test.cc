// SPDX-License-Identifier: BSD-3-Clause
//
// The office agent with planners over the map, or plain behaviours, in place of theories.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/integration/run_command.h"
#include "tests/integration/seed_runs.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

constexpr const char* kOffice = LATCHWORK_SOURCE_DIR "/examples/office/";
constexpr const char* kPlanners = LATCHWORK_SOURCE_DIR "/examples/office/ompl.xml";

void ExpectArrivals(const std::string& agent, const std::string& seeds,
                    std::vector<std::string> options = {}) {
  options.insert(options.end(), {"--scenario", kPlanners});
  const auto runs = RunSeeds("office/" + agent, seeds, options);
  ASSERT_FALSE(runs.empty());
  ExpectAllReached(runs);
  for (const auto& run : runs) EXPECT_EQ(run.at("collisions"), 0);
}

TEST(OfficeOmplTest, SameFloor) { ExpectArrivals("scenario1.xml", "1-2"); }
TEST(OfficeOmplTest, OneFloorUp) { ExpectArrivals("scenario2.xml", "1-2"); }
TEST(OfficeOmplTest, AnotherFloor) { ExpectArrivals("scenario3.xml", "1-2"); }

/// The elevator fails while the robot rides.
TEST(OfficeOmplTest, BadDay) { ExpectArrivals("events.xml", "1-2"); }

TEST(OfficeOmplTest, OtherPlanners) {
  ExpectArrivals("scenario2.xml", "1-2",
                 {"--set", "itinerary.reasoner.planner=PRM", "--set",
                  "elevators.reasoner.planner=KPIECE1", "--set", "seek.reasoner.planner=BITstar"});
}

/// One layer by the planner, the others by theories: only the reasoner of the layer is another.
class OfficeOmplLayerTest : public ::testing::TestWithParam<const char*> {};

TEST_P(OfficeOmplLayerTest, OneFloorUp) {
  const test::TemporaryFolder folder;
  const auto changes = folder.Write(
      "one.xml",
      std::string("<fragment format=\"1\"><override part=\"") + GetParam() +
          "\"><reasoner plugin=\"ompl\"><param name=\"map\" value=\"" LATCHWORK_SOURCE_DIR
          "/worlds/office/data/building/building.p\"/></reasoner></override></fragment>");
  const auto runs = RunSeeds("office/scenario2.xml", "1-2", {"--scenario", changes.string()});
  ASSERT_EQ(runs.size(), 2U);
  ExpectAllReached(runs);
}

INSTANTIATE_TEST_SUITE_P(Layers, OfficeOmplLayerTest,
                         ::testing::Values("seek", "elevators", "itinerary"),
                         [](const auto& layer) { return std::string(layer.param); });

/// Without any reasoner below: the reactive floor.
TEST(OfficeBrooksTest, AllScenarios) {
  for (const char* const agent : {"scenario1.xml", "scenario2.xml", "scenario3.xml"}) {
    const auto runs = RunSeeds(std::string("office/") + agent, "1-2",
                               {"--scenario", std::string(kOffice) + "brooks.xml"});
    ASSERT_EQ(runs.size(), 2U);
    ExpectAllReached(runs);
    for (const auto& run : runs) EXPECT_EQ(run.at("collisions"), 0);
  }
}

std::string JournalOf(const std::string& threads) {
  const test::TemporaryFolder folder;
  const CommandResult result =
      RunLatchwork({"run", std::string(kOffice) + "scenario2.xml", "--scenario", kPlanners,
                    "--ticks", "300", "--threads", threads, "--out", "out", "--quiet"},
                   folder.path());
  return ReadText(folder.path() / "out/run.journal");
}

TEST(OfficeOmplTest, SameSeed_SameJournal_WithThreadsToo) {
  const std::string journal = JournalOf("1");
  ASSERT_GT(journal.size(), 10'000U);
  EXPECT_TRUE(JournalOf("1") == journal);
  EXPECT_TRUE(JournalOf("3") == journal);
}

TEST(OfficeOmplTest, WrongMap_NamedWithLineAndColumn) {
  const test::TemporaryFolder folder;
  const CommandResult result =
      RunLatchwork({"run", std::string(kOffice) + "scenario1.xml", "--scenario", kPlanners, "--set",
                    "seek.reasoner.planner=RTRConnect", "--set", "itinerary.reasoner.map=no.p"},
                   folder.path());
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, ::testing::HasSubstr("RRTConnect"));
}

}  // namespace
}  // namespace latchwork::testing
