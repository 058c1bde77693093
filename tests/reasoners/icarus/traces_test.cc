// SPDX-License-Identifier: BSD-3-Clause
//
// The programs of the paper (Shapiro and Langley, Agents'99), and what they do in small worlds.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/reasoners/icarus/programs.h"
#include "tests/reasoners/icarus/script_run.h"

namespace latchwork::icarus::testing {
namespace {

RunOptions Acts(ActMode mode) {
  RunOptions options;
  options.acts = mode;
  return options;
}

TEST(IcarusTraceTest, Table1_CollidesWithTheCar) {
  const ScriptRun run(kCollide, R"(
    (top (CollideWithCar car54))
    (functions incontactwithcar)
    (cycle (answer {range-to car54} 9.0) (answer {facing car54} nil) (expect {turn}))
    (cycle (answer {facing car54} t) (expect {goforward}))
    (cycle (answer {range-to car54} 0.5) (expect {setpedal 100}))
    (cycle (expect {setpedal 100}))
    (cycle (answer {facing car54} nil) (expect {turn}))
    (cycle (answer {incontactwithcar car54} t) (expect true))
    (cycle (answer {incontactwithcar car54} nil) (answer {facing car54} t)
           (expect {setpedal 100})))");
  EXPECT_EQ(run.clauses(), (std::vector<std::uint64_t>{5, 9, 9, 9, 5, 2, 9}));
}

TEST(IcarusTraceTest, Table5_ActsLikeTheTeleoReactiveTree) {
  const ScriptRun run(R"(
    (CollideWithCar (?car)
      :requires ((*not* (TrueWhenInContact ?car)) (*not* (BumpItWhenNearAndFacing ?car))
                 (*not* (GoForwardWhenFacing ?car)) (*not* (TurnWhenTrue))))
    (TrueWhenInContact (?car) :objective ({InContactWith ?car}))
    (BumpItWhenNearAndFacing (?car) :requires ({Near ?car} {Facing ?car}) :means ((BumpIt)))
    (GoForwardWhenFacing (?car) :requires ({Facing ?car}) :means ((GoForward)))
    (TurnWhenTrue () :means ((Turn)))
    (Turn () :action ({turn}))
    (GoForward () :action ({goforward}))
    (BumpIt () :action ({bumpit})))",
                      R"(
    (top (CollideWithCar car54))
    (functions incontactwith near facing)
    (cycle (expect {turn}))
    (cycle (answer {facing ?} t) (expect {goforward}))
    (cycle (answer {near ?} t) (expect {bumpit}))
    (cycle (answer {facing ?} nil) (expect {turn}))
    (cycle (answer {incontactwith car54} t) (expect false)))");
  EXPECT_TRUE(run.faults().empty());
}

TEST(IcarusTraceTest, Figure2_RunsTheUniversalPlan) {
  const ScriptRun run(R"(
    (CollideWithCar (?car)
      :objective ({InContactWith ?car}) :requires ((Face ?car) (GetNear ?car)) :means ((BumpIt)))
    (Face (?car) :objective ({Facing ?car}) :requires () :means ((Turn)))
    (GetNear (?car) :objective ({Near ?car}) :requires () :means ((GoForward)))
    (Turn () :action ({turn}))
    (GoForward () :action ({goforward}))
    (BumpIt () :action ({bumpit})))",
                      R"(
    (top (CollideWithCar car54))
    (functions incontactwith near facing)
    (cycle (expect {turn}))
    (cycle (answer {near ?} t) (expect {turn}))
    (cycle (answer {near ?} nil) (answer {facing ?} t) (expect {goforward}))
    (cycle (answer {near ?} t) (expect {bumpit}))
    (cycle (answer {facing ?} nil) (answer {incontactwith ?} t) (expect true)))");
  EXPECT_TRUE(run.faults().empty());
}

constexpr std::string_view kBump = R"(
    (facts (driver car1 anna) (driver car2 bob) (driver car3 carl))
    (BumpIt (?car) :objective ((InContactWith ?car)) :requires ((HavePower ?car))
      :means ((Ram ?car) (Tap ?car)))
    (InContactWith (?car) :objective ({touching ?car}))
    (Ram (?car) :requires ((driver ?car ?person) {Enemy ?person}) :means ((SetPedal 100)))
    (Tap (?car) :requires ((driver ?car ?person) {Friend ?person}) :means ((SetPedal 20)))
    (HavePower (?car) :objective ({Power ?car ON}) :means ((HitPowerPole ?car)))
    (HitPowerPole (?car) :action ({hit-pole}))
    (SetPedal (?n) :action ({pedal ?n})))";

TEST(IcarusTraceTest, Table6_BumpsEnemiesHarderThanFriends) {
  const ScriptRun run(kBump, R"(
    (functions touching)
    (top (BumpIt car1))
    (cycle (answer {enemy anna} t) (answer {friend bob} t) (answer {power ? on} nil)
           (expect {hit-pole}))
    (cycle (top (BumpIt car3)) (expect {hit-pole}))
    (cycle (top (BumpIt car1)) (answer {power ? on} t) (expect {pedal 100}))
    (cycle (top (BumpIt car2)) (expect {pedal 20}))
    (cycle (top (BumpIt car3)) (expect false))
    (cycle (answer {touching car3} t) (expect true)))");
  EXPECT_TRUE(run.faults().empty());
}

TEST(IcarusTraceTest, Table6_TwoDrivers_GiveTwoActs) {
  for (const ActMode mode : {ActMode::kAll, ActMode::kFirst}) {
    const std::string expected = mode == ActMode::kAll ? "{pedal 100} {pedal 20}" : "{pedal 100}";
    const ScriptRun run(kBump,
                        "(functions touching) (top (BumpIt car1))"
                        "(cycle (store (driver car1 bob)) (answer {enemy anna} t)"
                        " (answer {friend bob} t) (answer {power ? on} t) (expect " +
                            expected + "))",
                        Acts(mode));
    EXPECT_TRUE(run.faults().empty());
  }
}

TEST(IcarusTraceTest, Table7_LooksForTheCarWhenMemoryIsOld) {
  const ScriptRun run(R"(
    (constant *OneCarLength* 1.0)
    (Near (?car ?d)
      :objective ((KnowLocation ?car ?loc) (Distance-to ?loc ?d) {< ?d *OneCarLength*}))
    (KnowLocation (?car ?loc) :objective ((?car ?loc ?time) {recent ?time})
      :means ((LookForCar ?car ?loc)))
    (LookForCar (?car ?loc) :objective ((CarsInView ?c) {member ?car ?c} (Location ?car ?loc))
      :means ((Turn)))
    (CarsInView (?c) :sensor ((bind ?c {cars-in-view})))
    (Location (?car ?loc) :sensor ((bind ?loc {locate ?car})
                                   {update (?car ? ?) (?car ?loc *cycle*)}))
    (Distance-to (?loc ?d) :sensor ((bind ?d {distance ?loc})))
    (Turn () :action ({turn})))",
                      R"(
    (top (Near car54 ?d))
    (cycle (answer {cars-in-view} ()) (answer {locate car54} (10 20)) (answer {recent ?} t)
           (answer {distance (10 20)} 0.5) (expect {turn}))
    (cycle (answer {cars-in-view} (car7 car54)) (expect true))
    (cycle (answer {cars-in-view} ()) (repeat 2) (expect true))
    (cycle (answer {recent 2} nil) (expect {turn}))
    (cycle (answer {cars-in-view} (car54)) (answer {distance (10 20)} 3.0) (expect false)))");
  EXPECT_EQ(run.Memory(), "(car54 (10 20) 6)");
}

TEST(IcarusTraceTest, Table8_FindsTheFastestCar) {
  const ScriptRun run(kFastest, R"(
    (top (MoveToFastestLane))
    (cycle (answer {car-ahead left} red) (answer {car-ahead center} green)
           (answer {car-ahead right} blue) (answer {speed-of red} 10) (answer {speed-of green} 20)
           (answer {speed-of blue} 30) (expect {behind blue}))
    (cycle (answer {speed-of red} 30) (answer {speed-of blue} 10) (expect {behind red}))
    (cycle (answer {speed-of red} 10) (answer {speed-of green} 30) (answer {speed-of blue} 20)
           (expect {behind green}))
    (cycle (answer {speed-of ?} 20) (answer {speed-of red} 20) (answer {speed-of green} 20)
           (answer {speed-of blue} 20) (expect {behind red}))
    (cycle (answer {speed-of red} fast) (expect false fault)))");
  EXPECT_EQ(run.faults(),
            (std::vector<std::string>{"{>=} is given a value of another type",
                                      "skills call each other deeper than the limit"}));
}

TEST(IcarusTraceTest, Table9_ProcessesAndSituations) {
  const ScriptRun processes(R"(
    (Ride () :objective ((CollideWithSomeCar) (DriveRecklessly)) :means ((DriveLaps)))
    (CollideWithSomeCar () :requires ({car-close}) :means ((Hit)))
    (DriveRecklessly () :objective ({reckless}))
    (Hit () :action ({hit}))
    (DriveLaps () :action ({lap})))",
                            R"(
    (top (Ride)) (functions reckless)
    (cycle (answer {car-close} nil) (expect {lap}))
    (cycle (answer {car-close} t) (repeat 3) (expect {hit})))");
  constexpr std::string_view kPlay = R"(
    (Play () :objective ((GenerateSpills) (GenerateThrills)) :means ((DriveLaps)))
    (GenerateSpills () :objective ((spill-count ?sc) {> ?sc 10}) :means ((Hit)))
    (GenerateThrills () :objective ((thrill-count ?tc) {> ?tc 10}) :means ((Floor)))
    (Hit () :action ({hit}))
    (Floor () :action ({floor}))
    (DriveLaps () :action ({lap})))";
  const ScriptRun situations(kPlay, R"(
    (top (Play))
    (cycle (store (spill-count 0)) (store (thrill-count 0)) (expect {hit}))
    (cycle (forget (spill-count ?)) (store (spill-count 11)) (expect {floor}))
    (cycle (forget (thrill-count ?)) (store (thrill-count 11)) (expect true)))");
  EXPECT_TRUE(situations.faults().empty());
}

constexpr std::string_view kDay = R"(
    (PlayBumperCars (?day) :sequence ((Pay ?day) (Ride ?day) (Leave ?day)))
    (Pay (?day) :objective ({paid ?day}) :means ((DoPay)))
    (Ride (?day) :objective ({ridden ?day}) :means ((Drive)))
    (Leave (?day) :objective ({outside ?day}) :means ((Walk)))
    (DoPay () :action ({pay}))
    (Drive () :action ({drive}))
    (Walk () :action ({walk})))";

TEST(IcarusTraceTest, Table10_SequenceIsKeptPerDay) {
  ScriptRun run(kDay, R"(
    (top (PlayBumperCars mon)) (functions paid ridden outside)
    (cycle (expect {pay}))
    (cycle (answer {paid ?} t) (expect {drive}))
    (cycle (answer {paid ?} nil) (expect {drive}))
    (cycle (top (PlayBumperCars tue)) (expect {pay}))
    (cycle (top (PlayBumperCars mon)) (expect {pay}))
    (cycle (answer {paid ?} t) (expect {drive}))
    (cycle (idle) (repeat 5) (expect false))
    (cycle (expect {drive}))
    (cycle (answer {ridden ?} t) (expect {walk}))
    (cycle (answer {outside ?} t) (expect true))
    (cycle (answer {outside ?} nil) (answer {paid ?} nil) (expect true)))");
  EXPECT_EQ(run.interpreter().sequence_states(), 1U);
}

TEST(IcarusTraceTest, Table10_ConditionsAreRechecked) {
  const ScriptRun run(R"(
    (PlayBumperCars () :objective ((Leave)))
    (Leave () :objective ({outside}) :requires ((Ride)) :means ((Walk)))
    (Ride () :objective ({ridden}) :requires ((Pay)) :means ((Drive)))
    (Pay () :objective ({paid}) :means ((DoPay)))
    (DoPay () :action ({pay}))
    (Drive () :action ({drive}))
    (Walk () :action ({walk})))",
                      R"(
    (top (PlayBumperCars)) (functions paid ridden outside)
    (cycle (expect {pay}))
    (cycle (answer {paid} t) (expect {drive}))
    (cycle (answer {paid} nil) (expect {pay}))
    (cycle (answer {ridden} t) (expect {walk}))
    (cycle (answer {outside} t) (expect true)))");
  EXPECT_TRUE(run.faults().empty());
}

TEST(IcarusTraceTest, RedAndBlue_AreAtDifferentSteps) {
  ScriptRun run(R"(
    (Top () :requires ((bumper-car ?b)) :means ((BumpSeq ?b)))
    (BumpSeq (?b) :sequence ((Aimed ?b) (Hit ?b) (Away ?b)))
    (Aimed (?b) :objective ({aimed ?b}) :means ((Aim ?b)))
    (Hit (?b) :objective ({was-hit ?b}) :means ((Charge ?b)))
    (Away (?b) :objective ({away ?b}) :means ((BackOff ?b)))
    (Aim (?b) :action ({aim ?b}))
    (Charge (?b) :action ({charge ?b}))
    (BackOff (?b) :action ({backoff ?b})))",
                R"(
    (top (Top)) (functions aimed was-hit away)
    (cycle (store (bumper-car red)) (store (bumper-car blue)) (expect {aim red} {aim blue}))
    (cycle (answer {aimed red} t) (expect {charge red} {aim blue}))
    (cycle (answer {was-hit red} t) (expect {backoff red} {aim blue}))
    (cycle (answer {aimed blue} t) (expect {backoff red} {charge blue}))
    (cycle (forget (bumper-car blue)) (expect {backoff red})))",
                Acts(ActMode::kAll));
  EXPECT_EQ(run.interpreter().sequence_states(), 1U);
}

constexpr std::string_view kMany = R"(
    (facts (car c1) (car c2) (car c3))
    (Top () :requires ((car ?c)) :means ((Deal ?c)))
    (Deal (?c) :requires ((Near ?c)) :means ((Hit ?c)) :value {worth ?c})
    (Near (?c) :objective ({near ?c}) :means ((Go ?c)))
    (Hit (?c) :action ({hit ?c}))
    (Go (?c) :action ({go ?c})))";

TEST(IcarusTraceTest, ManyBindings_GiveTheActsOfTheMode) {
  const auto script = [](const std::string& near, const std::string& expected) {
    return "(top (Top)) (cycle (answer {worth c1} 1) (answer {worth c2} 2) (answer {worth c3} 5)"
           " (answer {near " +
           near + "} t) (expect " + expected + "))";
  };
  const ScriptRun first(kMany, script("c2", "{go c1}"));
  const ScriptRun all(kMany, script("c2", "{go c1} {hit c2} {go c3}"), Acts(ActMode::kAll));
  const ScriptRun value(kMany, script("c2", "{go c3}"), Acts(ActMode::kValue));
  const ScriptRun near(kMany, script("c1", "{hit c1}"));
  EXPECT_TRUE(value.faults().empty());
}

TEST(IcarusTraceTest, Negation_TellsActsFromTruth) {
  const auto program = [](const std::string& negation) {
    return "(Top () :objective ((" + negation +
           " (X))))"
           "(X () :requires ((case ?k)) :means ((Y ?k)))"
           "(Y (?k) :objective ({true-in ?k}) :requires ({acts-in ?k}) :means ((Z)))"
           "(Z () :action ({z}))";
  };
  const auto script = [](const std::string& a, const std::string& b, const std::string& c,
                         const std::string& d) {
    return "(top (Top)) (functions true-in acts-in)"
           "(cycle (expect " +
           a +
           "))"
           "(cycle (store (case one)) (answer {true-in one} t) (expect " +
           b +
           "))"
           "(cycle (store (case two)) (answer {acts-in two} t) (answer {true-in one} nil)"
           " (expect " +
           c +
           "))"
           "(cycle (answer {true-in one} t) (expect " +
           d + "))";
  };
  const ScriptRun passing(program("*not*"), script("true", "false", "{z}", "{z}"));
  const ScriptRun strict(program("*notA*"), script("true", "false", "false", "false"));
  EXPECT_TRUE(strict.faults().empty());
}

TEST(IcarusTraceTest, Match_UnifiesNestedLists) {
  const ScriptRun run(R"(
    (facts (car car54) (car54 (10 20) 1:00:04))
    (A (?loc ?time) :objective ((car54 ?loc ?time)))
    (B (?x) :objective ((car54 (?x 20) ?)))
    (C () :objective ((?c (?x ?x) ?_t) {= ?c ?c})))",
                      R"(
    (top (A (10 20) 1:00:04))
    (cycle (expect true))
    (cycle (top (B 10)) (expect true))
    (cycle (top (C)) (expect false)))");
  EXPECT_TRUE(run.faults().empty());
}

}  // namespace
}  // namespace latchwork::icarus::testing
