// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "apps/compare/report/floor_plan.h"
#include "apps/compare/report/ompl_log.h"
#include "apps/compare/report/trajectory.h"
#include "apps/compare/report/verdicts.h"
#include "tests/apps/compare/trial.h"

namespace latchwork::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(VerdictsTest, Overview_SaysWhoIsWorseAtWhatAndWhere) {
  const Trial trial;
  EXPECT_EQ(Overview(trial.experiment, trial.findings),
            "Against good, slow is slower in floor; bad reaches fewer goals in floor and is slower "
            "in floor. No difference from good is shown for twin.");
}

TEST(VerdictsTest, Overview_SaysThatSoFewSeedsCannotShowAnything) {
  const Trial trial(4);
  EXPECT_THAT(Overview(trial.experiment, trial.findings),
              HasSubstr("4 seeds are too few to show any"));
}

TEST(VerdictsTest, AreOfTheAgentAgainstTheFirst) {
  const Trial trial;
  const std::vector<AgentVerdict> verdicts = Verdicts(trial.experiment, trial.findings);
  ASSERT_EQ(verdicts.size(), 3U);
  EXPECT_THAT(verdicts[0].differences, IsEmpty());
  EXPECT_THAT(verdicts[0].not_shown, ElementsAre("goals reached: floor (12 of 12 against 12)",
                                                 "time: floor (the same with every seed)"));
  ASSERT_EQ(verdicts[1].differences.size(), 1U);
  EXPECT_EQ(verdicts[1].differences[0].figures,
            "+20.0 s in the mean, 95 % +20.0 to +20.0 s; effect +1.00; p = 0.00293");
  ASSERT_EQ(verdicts[2].differences.size(), 2U);
  EXPECT_THAT(verdicts[2].differences[0].figures,
              HasSubstr("0 of 12 against 12: -100 points of 100"));
}

TEST(ReportTest, RefersToNothingOutside) {
  const std::string page = Trial().Page();
  for (const char* reference :
       {"http:", "https:", "src=", "@import", "url(", "<object", "<iframe"}) {
    EXPECT_THAT(page, Not(HasSubstr(reference)));
  }
}

TEST(ReportTest, TellsEveryFailureWithItsCommand) {
  const std::string page = Trial().Page();
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    EXPECT_THAT(page, HasSubstr("<code>latchwork run 'a &amp; b.xml' --seed " +
                                std::to_string(seed) + "</code>"));
  }
  EXPECT_THAT(page, HasSubstr("hit &lt;a wall&gt;"));
}

TEST(ReportTest, IsAFunctionOfItsInput) { EXPECT_EQ(Trial().Page(), Trial().Page()); }

TEST(ReportTest, AgentThatAlwaysFails_HasACurveWithoutAStep) {
  const std::string page = Trial().Page();
  const std::size_t curve = page.find("class=\"curve a3\" d=\"");
  ASSERT_NE(curve, std::string::npos);
  EXPECT_THAT(page.substr(curve, page.find("/>", curve) - curve), Not(HasSubstr("V")));
}

TEST(ReportTest, WorldWithoutPlans_HasNoTrajectories) {
  Trial trial;
  EXPECT_THAT(trial.Page(), HasSubstr("id=\"trajectories\""));
  trial.buildings["floor"].clear();
  EXPECT_THAT(trial.Page(), Not(HasSubstr("id=\"trajectories\"")));
}

TEST(ReportTest, PlansThatCouldNotBeDrawn_AreMissed) {
  Trial trial;
  trial.buildings.clear();
  EXPECT_THAT(trial.Page(), HasSubstr("The floors of floor could not be drawn"));
}

TEST(ReportTest, WithoutALimit_NothingIsSaidOfTimes) {
  Trial trial;
  for (auto& [key, run] : trial.records) {
    run.outcome = Outcome::kTimedOut;
    run.time_s = run.duration_s = 0;
  }
  trial.findings = Evaluate(trial.experiment, trial.records);
  const std::string text = ToText(trial.experiment, trial.findings);
  EXPECT_THAT(text, Not(HasSubstr("the same with every seed")));
  EXPECT_THAT(text, HasSubstr("0 of 12            -         -  12 timed out"));
  EXPECT_THAT(trial.Page(), HasSubstr("<td>0 of 12</td><td></td><td>-</td><td>-</td><td></td>"));
  EXPECT_THAT(ToOmplLog(trial.Input(), "floor"), HasSubstr("\nnan; 0; 4; nan;"));
}

TEST(ReportTest, AgentWithoutRuns_HasNoneYetInTextAndPage) {
  Trial trial;
  std::erase_if(trial.records, [](const auto& run) { return run.first.contender == "twin"; });
  trial.findings = Evaluate(trial.experiment, trial.records);
  const std::string text = ToText(trial.experiment, trial.findings);
  EXPECT_THAT(text, HasSubstr("Nothing is known yet of twin: good and it have no run with the"));
  EXPECT_THAT(text, HasSubstr("twin against good\n  nothing to compare yet"));
  EXPECT_THAT(text, HasSubstr("twin   no runs yet            -         -  -\n"));
  EXPECT_THAT(text, HasSubstr("36 of 48 runs are made so far"));
  EXPECT_THAT(text, Not(HasSubstr("No difference from good is shown")));
  const std::string page = trial.Page();
  EXPECT_THAT(page, HasSubstr("<li class=\"none\">nothing to compare yet"));
  EXPECT_THAT(page, HasSubstr("<td>no runs yet</td><td></td><td></td><td></td>"));
  EXPECT_THAT(page, Not(HasSubstr("0 of 0")));
}

TEST(ReportTest, WithoutAnyRun_NothingIsShownAndNothingDenied) {
  Trial trial;
  trial.records.clear();
  trial.findings = Evaluate(trial.experiment, trial.records);
  const std::string text = ToText(trial.experiment, trial.findings);
  EXPECT_THAT(text, HasSubstr("Nothing is known yet of twin, slow, bad"));
  EXPECT_THAT(text, Not(HasSubstr("too few")));
  EXPECT_THAT(text, HasSubstr("0 of 48 runs are made so far"));
}

TEST(ReportTest, ControlCharactersOfMessages_DoNotReachATerminal) {
  Trial trial;
  trial.findings.failures[0].message = "a\x1b[2J\xc2\x9b\n\xc3\xa9";
  EXPECT_THAT(ToText(trial.experiment, trial.findings), HasSubstr("collision: a [2J  \xc3\xa9)"));
}

TEST(ReportTest, TrajectoriesAreDrawnWhereThePlanSays) {
  const Trial trial;
  const FloorPlan& plan = trial.buildings.at("floor").at(1);
  EXPECT_EQ(plan.width, 200);
  EXPECT_EQ(plan.left, -1);
  EXPECT_EQ(plan.top, 4);
  EXPECT_EQ(plan.pixels, 20);
  EXPECT_THAT(trial.Page(), HasSubstr("class=\"way a0\" d=\"M40,100l0,0 20,0 0,-30\""));
}

TEST(FloorPlanTest, WhatIsNoDrawingOfAWorld_IsNoPlan) {
  EXPECT_FALSE(ReadPlan(""));
  EXPECT_FALSE(ReadPlan("<svg viewBox=\"0 0 10 10\"></svg>"));
  EXPECT_FALSE(ReadPlan("<svg viewBox=\"0 0 10\" data-area=\"0 0 1 1\"></svg>"));
  EXPECT_FALSE(ReadPlan("<svg viewBox=\"0 0 10 10\" data-area=\"1 0 1 1\"></svg>"));
  EXPECT_FALSE(ReadPlan("</svg><svg viewBox=\"0 0 9 9\" data-area=\"0 0 1 1\">"));
}

TEST(TrajectoryTextTest, IsReadByFloors) {
  EXPECT_THAT(ReadTrajectory("1 2.5,3 4.25,-3;2 9,9"),
              ElementsAre(Stay{1, {{2.5, 3}, {4.25, -3}}}, Stay{2, {{9, 9}}}));
  EXPECT_THAT(ReadTrajectory(""), IsEmpty());
}

TEST(TrajectoryTextTest, WhatIsTornOff_IsLeftOut) {
  EXPECT_THAT(ReadTrajectory("1 2,3;2 9"), ElementsAre(Stay{1, {{2, 3}}}));
  EXPECT_THAT(ReadTrajectory("one"), IsEmpty());
}

TEST(TrajectoryTextTest, PlacesThatNoDrawingCanShow_EndIt) {
  for (const char* place : {"nan,1", "1,inf", "1e300,1", "1,-1000001"}) {
    EXPECT_THAT(ReadTrajectory(std::string("1 2,3;2 ") + place), ElementsAre(Stay{1, {{2, 3}}}));
  }
}

TEST(SignedTest, NoughtsHaveNoSign) {
  EXPECT_EQ(Signed(-0.04, 1), "0.0");
  EXPECT_EQ(Signed(0, 0), "0");
  EXPECT_EQ(Signed(-0.05, 2), "-0.05");
  EXPECT_EQ(Signed(12.34, 1), "+12.3");
}

}  // namespace
}  // namespace latchwork::compare
