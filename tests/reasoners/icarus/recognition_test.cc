// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "reasoners/icarus/recognition/recogniser.h"

namespace latchwork::icarus::testing {
namespace {

std::string Example(const std::string& file) {
  std::ifstream stream(std::string(LATCHWORK_SOURCE_DIR) + "/examples/icarus/recognition/" + file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

const std::vector<std::string> kPlans = {"(RideForSpills)", "(RideForRevenge)", "(RideInPeace)",
                                         "(RideLaps)"};

std::vector<Evidence> Weigh(const std::string& recording) {
  const ProgramFile file = ReadProgram(Example("drivers.icarus"), "drivers.icarus");
  EXPECT_FALSE(HasErrors(file.findings));
  std::vector<Evidence> evidence;
  for (const std::string& plan : kPlans) {
    Findings findings;
    evidence.push_back(WeighPlan(file.program, plan, recording, "ride.world", findings));
    for (const Finding& finding : findings) ADD_FAILURE() << Format(finding);
  }
  return evidence;
}

std::size_t Best(const std::vector<Evidence>& evidence) {
  const std::vector<double> shares = Posterior(evidence);
  return static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
}

TEST(IcarusRecognitionTest, RecordedRide_IsThatOfTheAvenger) {
  const std::vector<Evidence> evidence = Weigh(Example("ride.world"));
  EXPECT_EQ(evidence[0].explained, 6U);
  EXPECT_EQ(evidence[1].explained, 8U);
  EXPECT_EQ(evidence[1].precision, 1);
  EXPECT_EQ(evidence[2].explained, 6U);
  EXPECT_EQ(evidence[3].explained, 4U);
  const std::vector<double> shares = Posterior(evidence);
  EXPECT_EQ(Best(evidence), 1U);
  EXPECT_GT(shares[1], 0.99);
  EXPECT_NEAR(shares[0] + shares[1] + shares[2] + shares[3], 1, 1e-12);
}

TEST(IcarusRecognitionTest, PlanThatOffersMore_IsLessLikelyThanTheOneThatOffersOnlyThis) {
  const std::vector<Evidence> bumps = Weigh(
      "(cycle (store (driver car2 bob)) (store (enemy bob)) (answer {close car2} t)"
      " (expect {bump hard}))");
  EXPECT_EQ(bumps[0].explained, 1U);
  EXPECT_EQ(bumps[0].precision, 0.5);
  EXPECT_EQ(Best(bumps), 1U);
  const std::vector<Evidence> soft = Weigh(
      "(cycle (store (driver car2 bob)) (store (enemy bob)) (answer {close car2} t)"
      " (expect {bump softly}))");
  EXPECT_EQ(Best(soft), 0U);
}

TEST(IcarusRecognitionTest, SensorsThatWereNotRecorded_AreFalse) {
  const std::vector<Evidence> laps = Weigh("(cycle (store (driver car2 bob)) (expect {lap}))");
  EXPECT_EQ(laps[2].unanswered, std::vector<std::string>{"close"});
  EXPECT_EQ(laps[2].explained, 1U);
}

TEST(IcarusRecognitionTest, ActOfTwoCalls_IsRecognisedInARecordingOfCalls) {
  const ProgramFile file = ReadProgram(
      "(Both () :action ({a} {b})) (First () :action ({a})) (Other () :action ({c}))", "p");
  std::vector<Evidence> evidence;
  for (const std::string plan : {"(Both)", "(First)", "(Other)"}) {
    Findings findings;
    evidence.push_back(WeighPlan(file.program, plan,
                                 "(cycle (expect {a} {b}))"
                                 "(cycle (expect {a} {b}))",
                                 "w", findings));
    EXPECT_TRUE(findings.empty());
  }
  EXPECT_EQ(evidence[0].explained, 2U);
  EXPECT_EQ(evidence[1].explained, 0U);
  EXPECT_EQ(evidence[2].explained, 0U);
  EXPECT_GT(Posterior(evidence)[0], 0.9);
}

TEST(IcarusRecognitionTest, Mistakes_AreFindings) {
  const ProgramFile file = ReadProgram(Example("drivers.icarus"), "drivers.icarus");
  Findings findings;
  WeighPlan(file.program, "(RideLaps", "(cycle (expect {lap}))", "w", findings);
  EXPECT_TRUE(HasErrors(findings));
  findings.clear();
  WeighPlan(file.program, "(RideLaps)", "(cycle (expcet {lap}))", "w", findings);
  EXPECT_TRUE(HasErrors(findings));
}

}  // namespace
}  // namespace latchwork::icarus::testing
