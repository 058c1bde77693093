// SPDX-License-Identifier: BSD-3-Clause
//
// Tables of the paper as they are printed, slips included: what is warned of, and what they do.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "reasoners/icarus/language/program.h"
#include "tests/reasoners/icarus/programs.h"
#include "tests/reasoners/icarus/script_run.h"

namespace latchwork::icarus::testing {
namespace {

bool Warns(std::string_view program, Code code) {
  const ProgramFile file = ReadProgram(std::string(program), "p.icarus");
  return std::any_of(file.findings.begin(), file.findings.end(),
                     [&](const Finding& finding) { return finding.code == code; });
}

TEST(IcarusPrintedTableTest, Table8_FiveArguments_AreWarnedOfAndDoTheSame) {
  std::string printed(kFastest);
  printed.replace(printed.find("?fastest-car ?)"), 15, "?fastest-car)");
  EXPECT_FALSE(Warns(kFastest, Code::kTooFewArguments));
  EXPECT_TRUE(Warns(printed, Code::kTooFewArguments));
  const ScriptRun run(printed, R"(
    (top (MoveToFastestLane))
    (cycle (answer {car-ahead left} red) (answer {car-ahead center} green)
           (answer {car-ahead right} blue) (answer {speed-of red} 10) (answer {speed-of green} 20)
           (answer {speed-of blue} 30) (expect {behind blue}))
    (cycle (answer {speed-of green} 40) (expect {behind green})))");
  EXPECT_TRUE(run.faults().empty());
}

TEST(IcarusPrintedTableTest, Table9_VariableHeads_MatchAnyPair) {
  const ScriptRun run(R"(
    (Play () :objective ((GenerateSpills) (GenerateThrills)) :means ((DriveLaps)))
    (GenerateSpills () :objective ((?spill-count ?sc) {> ?sc 10}) :means ((Hit)))
    (GenerateThrills () :objective ((?thrill-count ?tc) {> ?tc 10}) :means ((Floor)))
    (Hit () :action ({hit}))
    (Floor () :action ({floor}))
    (DriveLaps () :action ({lap})))",
                      R"(
    (top (Play))
    (cycle (store (spill-count 0)) (store (thrill-count 0)) (expect {hit}))
    (cycle (update (spill-count ?) (spill-count 11)) (expect true))
    (cycle (store (driver anna)) (expect true fault)))");
  ASSERT_FALSE(run.faults().empty());
  EXPECT_EQ(run.faults()[0], "{>} is given a value of another type");
}

TEST(IcarusPrintedTableTest, Table6_Flat_BumpsEnemiesOnly) {
  const ScriptRun run(R"(
    (facts (driver car1 anna) (driver car2 bob) (enemy anna))
    (BumpIt (?car)
      :objective ({InContactWith ?car})
      :requires ((HavePower) (Driver ?car ?person) (Enemy ?person))
      :means ((SetPedal 100)))
    (HavePower () :objective ({Power ON}) :means ((HitPowerPole)))
    (HitPowerPole () :action ({hit-pole}))
    (SetPedal (?n) :action ({pedal ?n})))",
                      R"(
    (top (BumpIt car1)) (functions incontactwith)
    (cycle (answer {power on} nil) (expect {hit-pole}))
    (cycle (answer {power on} t) (expect {pedal 100}))
    (cycle (top (BumpIt car2)) (expect false))
    (cycle (answer {incontactwith car2} t) (expect true)))");
  EXPECT_TRUE(run.faults().empty());
}

TEST(IcarusPrintedTableTest, Table6_HavePowerWithoutCar_IsWarnedOfAndFaulty) {
  constexpr std::string_view kPrinted = R"(
    (BumpIt (?car) :requires ((HavePower)) :means ((Ram ?car)))
    (Ram (?car) :action ({ram ?car}))
    (HavePower (?car) :objective ({Power ?car ON}) :means ((HitPowerPole ?car)))
    (HitPowerPole (?car) :action ({hit-pole ?car})))";
  EXPECT_TRUE(Warns(kPrinted, Code::kTooFewArguments));
  const ScriptRun run(kPrinted, R"(
    (top (BumpIt car1))
    (cycle (answer {power ? on} t) (expect false fault)))");
  EXPECT_EQ(run.faults().size(), 2U);
}

}  // namespace
}  // namespace latchwork::icarus::testing
