// SPDX-License-Identifier: BSD-3-Clause
//
// A goal that cannot be reached, under every reasoner: each says so at its first decision, within
// its budget, and the robot does not set out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* kOffice = LATCHWORK_SOURCE_DIR "/examples/office/";
constexpr std::size_t kDecisions = 10;  ///< Of the layer itinerary, one a second.

std::size_t Count(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

class WalledInTest : public ::testing::TestWithParam<const char*> {
 protected:
  /// Ten seconds; the journal goes to the folder `out`.
  CommandResult Drive() const {
    std::string script = "latchwork run " + std::string(kOffice) +
                         "walled_in.xml --ticks 100 --json --quiet --out out";
    if (GetParam() != std::string_view("pttp")) {
      script += " --scenario " + std::string(kOffice) + GetParam() + ".xml";
    }
    return RunShell(script, scratch_.path());
  }

  test::TemporaryFolder scratch_;
};

TEST_P(WalledInTest, NoWay_IsRefutedWithinTheBudget) {
  if (GetParam() == std::string_view("swipl") &&
      RunShell("command -v swipl", scratch_.path()).exit_code != 0) {
    GTEST_SKIP() << "there is no SWI-Prolog";
  }
  const CommandResult result = Drive();
  EXPECT_EQ(result.exit_code, 1) << result.err;
  const auto summary = nlohmann::json::parse(result.out, nullptr, false);
  ASSERT_TRUE(summary.is_object()) << result.out;
  EXPECT_EQ(summary.at("outcome"), "not reached");
  EXPECT_EQ(summary.at("collisions"), 0);
  EXPECT_EQ(summary.at("measures").at("distance_m"), 0.0);
  for (const auto& layer : summary.at("layers")) {
    EXPECT_EQ(layer.at("budget_hits"), 0) << layer.at("name");
    EXPECT_EQ(layer.at("faults"), 0) << layer.at("name");
  }
  const std::string journal = ReadText(scratch_.path() / "out/run.journal");
  EXPECT_EQ(Count(journal, R"({"layer":"itinerary","status":"refuted")"), kDecisions);
  EXPECT_EQ(Count(journal, R"({"layer":"itinerary","status":)"), kDecisions);
}

INSTANTIATE_TEST_SUITE_P(Reasoners, WalledInTest,
                         ::testing::Values("pttp", "circumscription", "icarus", "ompl", "brooks",
                                           "swipl"),
                         [](const auto& reasoner) { return std::string(reasoner.param); });

/// Saturation makes ever more situations, so that E can only say that its budget is used up. It
/// does at each decision, and in time.
TEST(WalledInBudgetTest, E_SaysThatItsBudgetIsUsedUp) {
  const test::TemporaryFolder scratch;
  if (RunShell("command -v eprover", scratch.path()).exit_code != 0) GTEST_SKIP() << "no E";
  const std::string office = kOffice;
  const CommandResult result =
      RunShell("latchwork run " + office + "walled_in.xml --scenario " + office +
                   "eprover.xml --ticks 100 --json --quiet --out out",
               scratch.path());
  EXPECT_EQ(result.exit_code, 1) << result.err;
  const auto summary = nlohmann::json::parse(result.out, nullptr, false);
  ASSERT_TRUE(summary.is_object()) << result.out;
  EXPECT_EQ(summary.at("outcome"), "not reached");
  EXPECT_EQ(summary.at("measures").at("distance_m"), 0.0);
  EXPECT_EQ(summary.at("layers").at(3).at("budget_hits"), kDecisions);
  EXPECT_EQ(summary.at("layers").at(3).at("faults"), 0);
  const std::string journal = ReadText(scratch.path() / "out/run.journal");
  EXPECT_EQ(Count(journal, R"({"layer":"itinerary","status":"unknown","limit":"inferences")"),
            kDecisions);
}

/// Theories say more than that there is no way: which default about a door did not hold.
TEST(WalledInReasonTest, RetractedDefault_IsNamed) {
  const test::TemporaryFolder scratch;
  const CommandResult result = RunLatchwork(
      {"explain", std::string(kOffice) + "walled_in.xml", "--layer", "itinerary"}, scratch.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("refuted"));
  EXPECT_THAT(result.out, HasSubstr("door_shut(d1_25)"));
}

}  // namespace
}  // namespace latchwork::testing
