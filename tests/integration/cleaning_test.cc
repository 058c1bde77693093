// SPDX-License-Identifier: BSD-3-Clause
//
// The robot of examples/icarus/cleaning.xml cleans its floor and comes home.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

class CleaningTest : public ::testing::TestWithParam<const char*> {};

TEST_P(CleaningTest, Run_FloorCleanAndBatteryNeverEmpty) {
  const test::TemporaryFolder folder;
  const CommandResult result =
      RunLatchwork({"run", LATCHWORK_SOURCE_DIR "/examples/icarus/cleaning.xml", "--seeds",
                    GetParam(), "--quiet", "--json"},
                   folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto run = nlohmann::json::parse(result.out);
  EXPECT_EQ(run.at("outcome"), "reached") << run.at("message");
  EXPECT_GE(run.at("measures").at("clean_part"), 0.95);
  EXPECT_GT(run.at("measures").at("lowest_charge"), 0);
  EXPECT_GE(run.at("measures").at("charges"), 2) << "it recharged and resumed";
  EXPECT_EQ(run.at("layers").at(0).at("faults"), 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CleaningTest, ::testing::Values("1", "2"));

}  // namespace
}  // namespace latchwork::testing
