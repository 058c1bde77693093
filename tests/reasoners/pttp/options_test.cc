// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/options.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "reasoners/pttp/strategies/schedule.h"

namespace latchwork::pttp {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string Readme() {
  std::ostringstream text;
  text << std::ifstream(LATCHWORK_SOURCE_DIR "/reasoners/pttp/README.md").rdbuf();
  return text.str();
}

std::string Range(const sdk::ParameterSpec& spec) {
  if (!std::isfinite(spec.maximum)) return "";
  return fmt::format("{} to {}", spec.minimum, spec.maximum);
}

std::string Row(const sdk::ParameterSpec& spec) {
  return fmt::format("| `{}` | {}{}{} | {} | {} |\n", spec.name, spec.default_value.value_or(""),
                     spec.unit.empty() ? "" : " ", spec.unit, Range(spec), spec.help);
}

ProverOptions OptionsWith(const std::vector<sdk::Parameters::Given>& given) {
  logic::Diagnostics diagnostics;
  const auto values = sdk::Parameters::Check(ProblemOptions(), given, "test", {}, diagnostics);
  EXPECT_THAT(diagnostics, IsEmpty());
  return OptionsFrom(values);
}

TEST(OptionsTest, Readme_ListsEveryOptionAsTheTablesHaveIt) {
  const std::string readme = Readme();
  for (const auto table : {LayerOptions(), ProblemOptions()}) {
    for (const sdk::ParameterSpec& spec : table) EXPECT_THAT(readme, HasSubstr(Row(spec)));
  }
}

TEST(OptionsTest, Defaults_AreThoseOfTheProver) {
  const ProverOptions options = OptionsWith({});
  const ProverOptions own;
  EXPECT_EQ(options.cpu_seconds, own.cpu_seconds);
  EXPECT_EQ(options.threads, own.threads);
  EXPECT_EQ(options.saturation, own.saturation);
  EXPECT_EQ(FindStrategy(options.strategy), nullptr);
  EXPECT_EQ(options.budget.inferences, std::numeric_limits<std::uint64_t>::max());
}

TEST(OptionsTest, GivenValues_ReachTheProver) {
  const ProverOptions options = OptionsWith({{"time", "0.5", {}},
                                             {"memory", "64", {}},
                                             {"inferences", "1000", {}},
                                             {"depth", "7", {}},
                                             {"strategy", "cut", {}},
                                             {"saturation", "false", {}},
                                             {"threads", "3", {}}});
  EXPECT_EQ(options.cpu_seconds, 0.5);
  EXPECT_EQ(options.memory_bytes, std::size_t{64} << 20U);
  EXPECT_EQ(options.budget.inferences, 1000U);
  EXPECT_EQ(options.budget.depth, 7U);
  EXPECT_EQ(options.strategy, "cut");
  EXPECT_FALSE(options.saturation);
  EXPECT_EQ(options.threads, 3U);
}

}  // namespace
}  // namespace latchwork::pttp
