// SPDX-License-Identifier: BSD-3-Clause
//
// `latchwork icarus learn`: what it keeps of what was learned.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

/// The lines `NAME MEAN` of what was validated, in their order.
std::vector<std::pair<std::string, double>> Validated(const std::string& out) {
  std::vector<std::pair<std::string, double>> means;
  std::istringstream lines(out.substr(0, out.find("kept")));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const std::size_t mean = line.find_last_of(' ') + 1;
    const std::size_t name_end = line.find_last_not_of(' ', mean - 1) + 1;
    means.emplace_back(line.substr(2, name_end - 2), std::stod(line.substr(mean)));
  }
  return means;
}

class IcarusLearnTest : public ::testing::Test {
 protected:
  /// Short drives in traffic, behind slow cars: the driver learns which way past them is best.
  std::string Learn(const std::string& values, const std::vector<std::string>& more) {
    std::vector<std::string> command = {"icarus",
                                        "learn",
                                        LATCHWORK_SOURCE_DIR "/examples/icarus/traffic.xml",
                                        "--layer",
                                        "driver",
                                        "--values",
                                        values,
                                        "--trials",
                                        "1",
                                        "--set",
                                        "driver.passing=free",
                                        "--set",
                                        "world.exit=400",
                                        "--set",
                                        "driver.exit_zone=50",
                                        "--set",
                                        "driver.lane_zone=50",
                                        "--train",
                                        "driver.reasoner.exploration=0.5"};
    command.insert(command.end(), more.begin(), more.end());
    const CommandResult result = RunLatchwork(command, scratch_.path());
    EXPECT_LE(result.exit_code, 1) << result.err;
    return result.out;
  }
  std::string Contents(const std::string& values) { return ReadText(scratch_.path() / values); }

  test::TemporaryFolder scratch_;
};

TEST_F(IcarusLearnTest, Validation_KeepsTheValuesThatWereBest) {
  const std::string out =
      Learn("kept.values", {"--fresh", "--episodes", "6", "--every", "2", "--validation", "2"});
  const auto means = Validated(out);
  ASSERT_EQ(means.size(), 4U) << out;
  std::size_t best = 0;
  for (std::size_t i = 0; i < means.size(); ++i) {
    EXPECT_EQ(means[i].first, i == 0 ? "unlearned" : std::to_string(2 * i) + " episodes");
    if (means[i].second > means[best].second) best = i;
  }
  if (best == 0) {
    EXPECT_NE(out.find("kept no values"), std::string::npos) << out;
    EXPECT_EQ(Contents("kept.values"), "");
    return;
  }
  const std::string episodes = std::to_string(2 * best);
  EXPECT_NE(out.find("kept the values after " + episodes + " episodes"), std::string::npos) << out;
  Learn("so_far.values", {"--fresh", "--episodes", episodes});
  EXPECT_EQ(Contents("kept.values"), Contents("so_far.values"));
  EXPECT_NE(Contents("kept.values"), "");
}

TEST_F(IcarusLearnTest, Validation_KeepsTheValuesItBeganWithWhenNoneAreBetter) {
  const std::string good = "(value (GoLeft 0 2 closed) 1 1)\n";
  WriteText(scratch_.path() / "v.values", good);
  const std::string out = Learn("v.values", {"--episodes", "0", "--validation", "1"});
  const auto means = Validated(out);
  ASSERT_EQ(means.size(), 2U) << out;
  EXPECT_EQ(means[1].first, "0 episodes");
  EXPECT_EQ(Contents("v.values"), means[1].second > means[0].second ? good : "");
}

}  // namespace
}  // namespace latchwork::testing
