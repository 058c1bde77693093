// SPDX-License-Identifier: BSD-3-Clause
//
// The gardener of examples/icarus/garden.xml brings its pumpkins through the season.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

class GardenTest : public ::testing::TestWithParam<const char*> {};

TEST_P(GardenTest, Seasons_AllPumpkinsLiveAndWeighEnough) {
  const test::TemporaryFolder folder;
  const CommandResult result =
      RunLatchwork({"run", LATCHWORK_SOURCE_DIR "/examples/icarus/garden.xml", "--seeds",
                    GetParam(), "--quiet", "--json"},
                   folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto runs = nlohmann::json::parse(result.out);
  ASSERT_EQ(runs.size(), 2U);
  for (const auto& run : runs) {
    EXPECT_EQ(run.at("outcome"), "reached") << run.at("seed") << ": " << run.at("message");
    EXPECT_EQ(run.at("measures").at("alive"), run.at("measures").at("plants"));
    EXPECT_EQ(run.at("layers").at(0).at("faults"), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(TwentySeeds, GardenTest,
                         ::testing::Values("1-2", "3-4", "5-6", "7-8", "9-10", "11-12", "13-14",
                                           "15-16", "17-18", "19-20"));

}  // namespace
}  // namespace latchwork::testing
