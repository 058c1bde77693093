// SPDX-License-Identifier: BSD-3-Clause
//
// `latchwork icarus record` on the worlds: their runs come out the same in a script.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using ::testing::HasSubstr;

struct Case {
  const char* name;
  const char* agent;
  const char* options;
};

constexpr const char* kOffice =
    "examples/office/scenario3.xml --scenario examples/office/icarus.xml";

class IcarusRecordTest : public ::testing::TestWithParam<Case> {};

/// With 0, each cycle of the run has come out in the script as it did in the layer.
TEST_P(IcarusRecordTest, Run_ComesOutTheSame) {
  const test::TemporaryFolder scratch;
  const CommandResult result =
      RunShell(std::string("latchwork icarus record --quiet ") + GetParam().agent + ' ' +
                   GetParam().options + " > " + (scratch.path() / "it.world").string(),
               LATCHWORK_SOURCE_DIR);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string script = ReadText(scratch.path() / "it.world");
  EXPECT_THAT(script, HasSubstr("(cycle (store "));
  EXPECT_THAT(script, HasSubstr("(expect {"));
}

INSTANTIATE_TEST_SUITE_P(
    Worlds, IcarusRecordTest,
    ::testing::Values(
        Case{"hanoi", "examples/icarus/hanoi.xml", "--layer player --seed 7"},
        Case{"bumper_cars", "examples/icarus/bumper_cars.xml", "--layer driver --seed 3"},
        Case{"bumper_day", "examples/icarus/bumper_day.xml", "--layer driver --seed 3"},
        Case{"cart_pole", "examples/icarus/cart_pole.xml", "--layer balancer --seed 3"},
        Case{"cleaning", "examples/icarus/cleaning.xml", "--layer cleaner --ticks 2000"},
        Case{"garden", "examples/icarus/garden.xml", "--layer gardener --ticks 3000"},
        Case{"traffic", "examples/icarus/traffic.xml", "--layer driver --seed 3"},
        Case{"avoid", kOffice, "--layer avoid --seed 2"},
        Case{"seek", kOffice, "--layer seek --seed 2"},
        Case{"elevators", kOffice, "--layer elevators --seed 2"},
        Case{"itinerary", kOffice, "--layer itinerary --seed 2"}),
    [](const auto& of) { return std::string(of.param.name); });

TEST(IcarusRecordCommandTest, ScriptHolds_WithItsOwnCommand) {
  const test::TemporaryFolder scratch;
  ASSERT_EQ(RunShell("latchwork icarus record examples/icarus/hanoi.xml --layer player --ticks 90 "
                     "--quiet > " +
                         (scratch.path() / "it.world").string(),
                     LATCHWORK_SOURCE_DIR)
                .exit_code,
            0);
  const CommandResult same = RunShell(
      "$(sed -n 's/;  *\\(latchwork icarus run .*\\)FILE/\\1it.world/p' it.world)", scratch.path());
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("\n90: "));
  // A program that does otherwise is found out.
  WriteText(scratch.path() / "other.icarus", "(top (Wait))\n(Wait () :action ({wait}))\n");
  EXPECT_EQ(
      RunShell("latchwork icarus run other.icarus --script it.world", scratch.path()).exit_code, 1);
}

TEST(IcarusRecordCommandTest, LayersWithoutASingleProgram_AreRefused) {
  const auto record = [](const std::string& options) {
    return RunShell("latchwork icarus record " + options, LATCHWORK_SOURCE_DIR);
  };
  const CommandResult theory = record("examples/office/scenario1.xml --layer avoid");
  EXPECT_EQ(theory.exit_code, 3);
  EXPECT_THAT(theory.err, HasSubstr("is driven by pttp, but only icarus runs programs"));
  const CommandResult unknown = record("examples/icarus/hanoi.xml --layer plyer");
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean 'player'?"));
  const CommandResult learned = record(
      "examples/icarus/hanoi.xml --layer player --set player.reasoner.learn=true "
      "--set player.reasoner.values=none.values");
  EXPECT_EQ(learned.exit_code, 3);
  EXPECT_THAT(learned.err, HasSubstr("learned values have no place in a script"));
  EXPECT_EQ(record("examples/icarus/hanoi.xml").exit_code, 2);
}

}  // namespace
}  // namespace latchwork::testing
