// SPDX-License-Identifier: BSD-3-Clause
//
// The office agent with Icarus programs in place of theories: in all layers, and in each alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using test::TemporaryFolder;

constexpr const char* kExamples = LATCHWORK_SOURCE_DIR "/examples/office/";

/// Runs an agent of the office with the fragment `changes` on top; expects it to arrive unharmed.
void ExpectArrival(const std::string& agent, const std::string& changes, const std::string& seed) {
  const TemporaryFolder folder;
  const CommandResult result = RunLatchwork(
      {"run", kExamples + agent, "--scenario", changes, "--seed", seed, "--out", "out", "--quiet"},
      folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto summary = nlohmann::json::parse(ReadText(folder.path() / "out/summary.json"));
  EXPECT_EQ(summary.at("outcome"), "reached");
  EXPECT_EQ(summary.at("collisions"), 0);
}

TEST(OfficeIcarusTest, AllLayers_SameFloor) {
  ExpectArrival("scenario1.xml", std::string(kExamples) + "icarus.xml", "1");
}
TEST(OfficeIcarusTest, AllLayers_OneFloorUp) {
  ExpectArrival("scenario2.xml", std::string(kExamples) + "icarus.xml", "2");
}
TEST(OfficeIcarusTest, AllLayers_AnotherFloor) {
  ExpectArrival("scenario3.xml", std::string(kExamples) + "icarus.xml", "3");
}
TEST(OfficeIcarusTest, AllLayers_ABadDay) {
  ExpectArrival("events.xml", std::string(kExamples) + "icarus.xml", "1");
}

/// One layer by a program, the others by theories.
class OfficeIcarusLayerTest : public ::testing::TestWithParam<const char*> {};

TEST_P(OfficeIcarusLayerTest, OneFloorUp) {
  const TemporaryFolder folder;
  const auto changes =
      folder.Write("one.xml", std::string("<fragment format=\"1\"><override part=\"") + GetParam() +
                                  "\"><reasoner plugin=\"icarus\"/></override></fragment>");
  ExpectArrival("scenario2.xml", changes.string(), "1");
}

INSTANTIATE_TEST_SUITE_P(Layers, OfficeIcarusLayerTest,
                         ::testing::Values("avoid", "seek", "elevators", "itinerary"),
                         [](const auto& layer) { return std::string(layer.param); });

}  // namespace
}  // namespace latchwork::testing
