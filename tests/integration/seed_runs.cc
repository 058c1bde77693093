// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/seed_runs.h"

#include <gtest/gtest.h>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {

std::vector<nlohmann::json> RunSeeds(const std::string& example, const std::string& seeds,
                                     const std::vector<std::string>& options) {
  const test::TemporaryFolder folder;
  std::vector<std::string> arguments{
      "run", LATCHWORK_SOURCE_DIR "/examples/" + example, "--seeds", seeds, "--json", "--quiet"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const CommandResult result = RunLatchwork(arguments, folder.path());
  const nlohmann::json runs = nlohmann::json::parse(result.out, nullptr, false);
  if (!runs.is_array()) {
    ADD_FAILURE() << result.out << result.err;
    return {};
  }
  return runs.get<std::vector<nlohmann::json>>();
}

void ExpectAllReached(const std::vector<nlohmann::json>& runs) {
  for (const nlohmann::json& run : runs) {
    EXPECT_EQ(run.at("outcome"), "reached")
        << "seed " << run.at("seed") << ": " << run.at("message");
    EXPECT_TRUE(run.at("faults").empty()) << "seed " << run.at("seed") << run.at("faults");
  }
}

}  // namespace latchwork::testing
