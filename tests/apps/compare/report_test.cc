// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "apps/compare/report/floor_plan.h"
#include "apps/compare/report/html.h"
#include "apps/compare/report/trajectory.h"
#include "apps/compare/report/verdicts.h"
#include "latchwork/sdk/svg.h"

namespace latchwork::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

RunRecord RunOf(const std::string& contender, std::uint64_t seed, Outcome outcome, double time_s) {
  RunRecord run;
  run.key = {"floor", contender, seed};
  run.outcome = outcome;
  run.time_s = time_s;
  run.duration_s = 600;
  run.command = "latchwork run 'a & b.xml' --seed " + std::to_string(seed);
  run.message = outcome == Outcome::kReached ? "" : "hit <a wall>";
  run.trajectory = "1 1,1 2,1 2,2.5";
  run.layers = {{"avoid", "pttp", 10, 2.5, 0, 0, 0, 12, 11, 20}};
  return run;
}

/// good and twin always arrive, at the same times; slow 20 s later; bad fails with every seed.
class ReportTest : public ::testing::Test {
 protected:
  explicit ReportTest(std::uint64_t seeds = 12) {
    experiment_.name = "trial";
    experiment_.last_seed = seeds;
    experiment_.scenarios = {{"floor", "floor.xml"}};
    for (const char* name : {"good", "twin", "slow", "bad"}) {
      experiment_.contenders.push_back({name, {}, {}});
    }
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const double time = 100 + 3.0 * static_cast<double>(seed);
      Add(RunOf("good", seed, Outcome::kReached, time));
      Add(RunOf("twin", seed, Outcome::kReached, time));
      Add(RunOf("slow", seed, Outcome::kReached, time + 20));
      Add(RunOf("bad", seed, Outcome::kCollision, time));
    }
    findings_ = Evaluate(experiment_, records_);
  }

  void Add(const RunRecord& run) { records_.emplace(run.key, run); }

  std::string Page() const {
    return ToHtml({experiment_,
                   records_,
                   findings_,
                   buildings_,
                   {"latchwork compare trial.xml", "latchwork 1.2.3"}});
  }

  Experiment experiment_;
  Records records_;
  Findings findings_;
  std::map<std::string, Building> buildings_;
};

class ReportOfFewSeedsTest : public ReportTest {
 protected:
  ReportOfFewSeedsTest() : ReportTest(4) {}
};

TEST_F(ReportTest, Overview_SaysWhoIsWorseAtWhatAndWhere) {
  EXPECT_EQ(Overview(experiment_, findings_),
            "Against good, slow is slower in floor; bad reaches fewer goals in floor and is slower "
            "in floor. No difference from good is shown for twin.");
}

TEST_F(ReportOfFewSeedsTest, Overview_SaysThatNothingCanBeShown) {
  EXPECT_THAT(Overview(experiment_, findings_), HasSubstr("4 seeds are too few to show any"));
}

TEST_F(ReportTest, Verdicts_AreOfTheAgentAgainstTheFirst) {
  const std::vector<AgentVerdict> verdicts = Verdicts(experiment_, findings_);
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

TEST_F(ReportTest, Page_RefersToNothingOutside) {
  const std::string page = Page();
  for (const char* reference :
       {"http:", "https:", "src=", "@import", "url(", "<object", "<iframe"}) {
    EXPECT_THAT(page, Not(HasSubstr(reference)));
  }
}

TEST_F(ReportTest, Page_TellsEveryFailureWithItsCommand) {
  const std::string page = Page();
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    EXPECT_THAT(page, HasSubstr("<code>latchwork run 'a &amp; b.xml' --seed " +
                                std::to_string(seed) + "</code>"));
  }
  EXPECT_THAT(page, HasSubstr("hit &lt;a wall&gt;"));
}

TEST_F(ReportTest, Page_IsAFunctionOfItsInput) { EXPECT_EQ(Page(), Page()); }

TEST_F(ReportTest, FailuresKeepTheCurveBelowTheTop) {
  const std::string page = Page();
  const std::size_t curve = page.find("class=\"curve a3\" d=\"");
  ASSERT_NE(curve, std::string::npos);
  const std::string path = page.substr(curve, page.find("/>", curve) - curve);
  EXPECT_THAT(path, Not(HasSubstr("V"))) << "bad never reaches its goal: no step up";
}

TEST_F(ReportTest, WorldWithoutPlans_HasNoTrajectories) {
  EXPECT_THAT(Page(), Not(HasSubstr("id=\"trajectories\"")));
}

TEST_F(ReportTest, Trajectories_AreDrawnWhereThePlanSays) {
  sdk::Svg svg({.x1 = -1, .y1 = 0, .x2 = 9, .y2 = 4}, 20);
  svg.Rectangle({0, 0}, {1, 1}, {.fill = "currentColor"});
  const std::optional<FloorPlan> plan = ReadPlan(svg.ToString());
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->width, 200);
  EXPECT_EQ(plan->left, -1);
  EXPECT_EQ(plan->top, 4);
  EXPECT_EQ(plan->pixels, 20);
  buildings_["floor"] = {{1, *plan}};
  EXPECT_THAT(Page(), HasSubstr("class=\"way a0\" d=\"M40,100l0,0 20,0 0,-30\""));
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

TEST(SignedTest, NoughtsHaveNoSign) {
  EXPECT_EQ(Signed(-0.04, 1), "0.0");
  EXPECT_EQ(Signed(0, 0), "0");
  EXPECT_EQ(Signed(-0.05, 2), "-0.05");
  EXPECT_EQ(Signed(12.34, 1), "+12.3");
}

}  // namespace
}  // namespace latchwork::compare
