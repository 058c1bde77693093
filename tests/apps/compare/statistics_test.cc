// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "apps/compare/statistics/comparison.h"
#include "apps/compare/statistics/holm.h"
#include "apps/compare/statistics/sample_size.h"
#include "apps/compare/statistics/shares.h"
#include "latchwork/sdk/random.h"

namespace latchwork::compare {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

TEST(McNemarTest, AgreesWithTheBinomialDistribution) {
  EXPECT_DOUBLE_EQ(McNemarExact({0, 0}), 1);
  EXPECT_DOUBLE_EQ(McNemarExact({3, 3}), 1);
  EXPECT_DOUBLE_EQ(McNemarExact({0, 5}), 2.0 / 32);
  EXPECT_DOUBLE_EQ(McNemarExact({9, 1}), 2 * 11.0 / 1024);
}

// Approval of a prime minister in two surveys, 150 and 86 who changed their minds: z = 4.17
// (Agresti, Categorical data analysis, 2nd edition, table 10.1).
TEST(McNemarTest, ManyPairs_AgreeWithTheNormalApproximation) {
  EXPECT_NEAR(McNemarExact({150, 86}), std::erfc(64 / std::sqrt(236.0) / std::sqrt(2.0)), 1e-5);
}

// Hamilton's depression scale before and after a tranquilizer: V = 40 of 45, p = 0.01953 on one
// side (Hollander and Wolfe 1973, table 3.1).
TEST(WilcoxonTest, DepressionScores_AsPublished) {
  const std::vector<double> before = {1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const std::vector<double> after = {0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  std::vector<double> differences;
  for (std::size_t i = 0; i < before.size(); ++i) differences.push_back(before[i] - after[i]);
  const SignedRanks ranks = WilcoxonSignedRanks(differences);
  EXPECT_NEAR(ranks.p, 2 * 0.01953125, 1e-12);
  EXPECT_NEAR(ranks.effect, (40.0 - 5.0) / 45.0, 1e-12);
  EXPECT_EQ(ranks.counted, 9U);
  EXPECT_TRUE(ranks.exact);
}

// Darwin's pairs of maize, eighths of an inch: 96 and 24 of 120; 0.041 on two sides (Fisher, The
// design of experiments, and many after him).
TEST(WilcoxonTest, DarwinsMaize_AsPublished) {
  const std::vector<double> maize = {49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48};
  const SignedRanks ranks = WilcoxonSignedRanks(maize);
  EXPECT_NEAR(ranks.effect, (96.0 - 24.0) / 120.0, 1e-12);
  EXPECT_NEAR(ranks.p, 0.04126, 1e-4);
}

TEST(WilcoxonTest, Zeros_SayNothing) {
  EXPECT_EQ(WilcoxonSignedRanks(std::vector<double>{0, 0}).p, 1);
  const SignedRanks with = WilcoxonSignedRanks(std::vector<double>{0, 1, 2, -3, 0});
  EXPECT_EQ(with.p, WilcoxonSignedRanks(std::vector<double>{1, 2, -3}).p);
  EXPECT_EQ(with.counted, 3U);
}

/// The share of all sign patterns with a sum of ranks as far from the middle.
double ByEnumeration(const std::vector<double>& ranks, double distance) {
  double all = 0;
  for (const double rank : ranks) all += rank;
  std::size_t extreme = 0;
  for (std::uint32_t signs = 0; signs < (1U << ranks.size()); ++signs) {
    double sum = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
      if ((signs >> i & 1U) != 0) sum += ranks[i];
    }
    if (std::abs(sum - all / 2) >= distance - 1e-9) ++extreme;
  }
  return static_cast<double>(extreme) / static_cast<double>(1U << ranks.size());
}

TEST(WilcoxonTest, Ties_AreCountedExactly) {
  const std::vector<double> ranks = {1.5, 1.5, 4, 4, 4, 6, 7.5, 7.5};
  const SignedRanks found = WilcoxonSignedRanks(std::vector<double>{1, 1, 2, 2, -2, 3, 4, -4});
  EXPECT_NEAR(found.p, ByEnumeration(ranks, std::abs(36.0 - 11.5 - 18.0)), 1e-12);
}

TEST(WilcoxonTest, ApproximationMeetsTheExactTest) {
  const sdk::RandomStream stream(3, "differences");
  std::vector<double> differences;
  for (std::uint64_t i = 0; i < 60; ++i) differences.push_back(stream.Gaussian(i) + 0.25);
  const double exact = WilcoxonSignedRanks(differences).p;
  differences.push_back(1e-9);
  const SignedRanks approximate = WilcoxonSignedRanks(differences);
  EXPECT_FALSE(approximate.exact);
  EXPECT_NEAR(approximate.p, exact, 0.02);
}

TEST(HolmTest, CorrectsStepByStep) {
  EXPECT_THAT(Holm(std::vector<double>{0.01, 0.02, 0.03, 0.04}),
              ElementsAre(DoubleNear(0.04, 1e-12), DoubleNear(0.06, 1e-12), DoubleNear(0.06, 1e-12),
                          DoubleNear(0.06, 1e-12)));
  EXPECT_THAT(Holm(std::vector<double>{0.9, 0.001}),
              ElementsAre(DoubleNear(0.9, 1e-12), DoubleNear(0.002, 1e-12)));
  EXPECT_TRUE(Holm({}).empty());
}

TEST(BootstrapTest, CoversTheMeanOfSkewedSamplesAsOftenAsItSays) {
  const sdk::RandomStream stream(11, "samples");
  std::size_t covered = 0;
  constexpr std::size_t kTrials = 300;
  for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
    std::vector<double> sample;
    for (std::uint64_t i = 0; i < 40; ++i) sample.push_back(-std::log1p(-stream.Uniform(trial, i)));
    const Interval interval = BootstrapInterval(sample, trial);
    if (interval.low <= 1 && 1 <= interval.high) ++covered;
  }
  EXPECT_GE(covered, kTrials * 90 / 100);
  EXPECT_LE(covered, kTrials * 99 / 100);
}

TEST(BootstrapTest, IsAFunctionOfItsSeed) {
  const std::vector<double> sample = {1, 2, 4, 8, 16};
  const Interval interval = BootstrapInterval(sample, 5);
  EXPECT_DOUBLE_EQ(interval.mean, 6.2);
  EXPECT_EQ(interval.low, BootstrapInterval(sample, 5).low);
  EXPECT_LT(interval.low, interval.mean);
  EXPECT_GT(interval.high, interval.mean);
}

TEST(BootstrapTest, EqualValues_HaveNoWidth) {
  const Interval interval = BootstrapInterval(std::vector<double>{3, 3, 3}, 1);
  EXPECT_EQ(interval.low, 3);
  EXPECT_EQ(interval.high, 3);
}

// Newcombe, Two-sided confidence intervals for the single proportion (1998), table I, method 3.
TEST(ShareTest, ScoreIntervals_AsPublished) {
  const Interval many = Share(81, 263);
  EXPECT_NEAR(many.low, 0.2553, 5e-5);
  EXPECT_NEAR(many.high, 0.3662, 5e-5);
  const Interval few = Share(15, 148);
  EXPECT_NEAR(few.low, 0.0624, 5e-5);
  EXPECT_NEAR(few.high, 0.1605, 5e-5);
  EXPECT_NEAR(Share(0, 20).high, 0.1611, 5e-5);
  EXPECT_NEAR(Share(1, 29).low, 0.0061, 5e-5);
  EXPECT_NEAR(Share(1, 29).high, 0.1718, 5e-5);
}

TEST(ShareTest, NoRuns_SayNothing) {
  EXPECT_EQ(Share(0, 0).high, 1);
  EXPECT_EQ(DifferenceOfShares({0, 0}, 0).low, -1);
}

// The prime minister's approval again: 0.04, from 0.02 to 0.06.
TEST(DifferenceOfSharesTest, Approval_AsPublished) {
  const Interval difference = DifferenceOfShares({150, 86}, 1600);
  EXPECT_NEAR(difference.mean, 0.04, 5e-4);
  EXPECT_NEAR(difference.low, 0.02, 2e-3);
  EXPECT_NEAR(difference.high, 0.06, 2e-3);
  EXPECT_EQ(DifferenceOfShares({86, 150}, 1600).low, -difference.high);
}

TEST(DifferenceOfSharesTest, HoldsTheEstimateAtTheEdges) {
  EXPECT_EQ(DifferenceOfShares({30, 0}, 30).high, 1);
  EXPECT_LT(DifferenceOfShares({30, 0}, 30).low, 1);
  EXPECT_LT(DifferenceOfShares({0, 0}, 30).low, 0);
}

TEST(DifferenceOfSharesTest, CoversTheTruthAsOftenAsItSays) {
  const sdk::RandomStream stream(23, "pairs");
  std::size_t covered = 0;
  constexpr std::size_t kTrials = 4000;
  for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
    Discordant discordant;
    for (std::uint64_t i = 0; i < 30; ++i) {
      const double draw = stream.Uniform(trial, i);
      if (draw < 0.3) ++discordant.only_first;
      if (draw >= 0.3 && draw < 0.4) ++discordant.only_second;
    }
    const Interval interval = DifferenceOfShares(discordant, 30);
    if (interval.low <= 0.2 && 0.2 <= interval.high) ++covered;
  }
  EXPECT_GE(covered, kTrials * 93 / 100);
  EXPECT_LE(covered, kTrials * 98 / 100);
}

// Noether's formula by hand, for P(X + X' > 0) = 0.73: (1.645 + 1.282)^2 / (3 * 0.23^2) = 54.
TEST(SampleSizeTest, SignedRanks_AsByHand) {
  const double shift = 0.6128129910166272 / std::sqrt(2.0);
  EXPECT_NEAR(static_cast<double>(PairsForTime(shift, {0.10, 0.9})), 54, 1);
  EXPECT_EQ(PairsForTime(0, {}), 0U);
}

TEST(SampleSizeTest, Success_ReachesItsPowerInSimulation) {
  const std::size_t pairs = PairsForSuccess(0.3, 0.05, {0.05, 0.8});
  ASSERT_GT(pairs, 10U);
  const sdk::RandomStream stream(17, "pairs");
  std::size_t found = 0;
  constexpr std::size_t kTrials = 4000;
  for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
    Discordant discordant;
    for (std::uint64_t i = 0; i < pairs; ++i) {
      const double draw = stream.Uniform(trial, i);
      if (draw < 0.3) ++discordant.only_first;
      if (draw >= 0.3 && draw < 0.35) ++discordant.only_second;
    }
    if (McNemarExact(discordant) <= 0.05) ++found;
  }
  EXPECT_NEAR(static_cast<double>(found) / kTrials, 0.8, 0.03);
}

TEST(SampleSizeTest, EqualAgents_CannotBeToldApart) {
  EXPECT_EQ(PairsForSuccess(0.1, 0.1, {}), 0U);
}

std::vector<RunScore> Runs(std::uint64_t seed, double shift, double failing) {
  const sdk::RandomStream common(7, "scenario");
  const sdk::RandomStream own(seed, "agent");
  std::vector<RunScore> runs;
  for (std::uint64_t i = 0; i < 60; ++i) {
    runs.push_back({own.Uniform(i) >= failing,
                    100 + 30 * common.Gaussian(i) + 3 * own.Gaussian(i, 1) + shift});
  }
  return runs;
}

TEST(ComparisonTest, SameAgentTwice_NothingIsFound) {
  std::vector<Comparison> comparisons;
  for (std::uint64_t i = 0; i < 40; ++i) {
    comparisons.push_back(Compare(Runs(2 * i, 0, 0.1), Runs(2 * i + 1, 0, 0.1), 300, i));
  }
  CorrectTogether(comparisons);
  for (const Comparison& each : comparisons) {
    EXPECT_EQ(OnSuccess(each, 0.05), Verdict::kNoDifferenceShown);
    EXPECT_EQ(OnTime(each, 0.05), Verdict::kNoDifferenceShown);
  }
}

// Thousands of experiments in which there is nothing to find, with failures and ties: two agents
// against a third that is no different, in seeds of unequal difficulty.
TEST(ComparisonTest, SameAgents_AreToldApartAsSeldomAsTheLevelSays) {
  constexpr std::size_t kExperiments = 2000;
  constexpr std::uint64_t kSeeds = 12;
  const sdk::RandomStream difficulty(29, "difficulty");
  const sdk::RandomStream luck(29, "luck");
  const auto play = [&](std::uint64_t experiment, std::uint64_t agent) {
    std::vector<RunScore> runs;
    for (std::uint64_t i = 0; i < kSeeds; ++i) {
      const std::uint64_t draw = (experiment * kSeeds + i) * 3 + agent;
      const double hard = difficulty.Uniform(experiment, i);
      runs.push_back({luck.Uniform(draw) >= 0.5 * hard,
                      std::round(60 + 30 * hard + 4 * luck.Gaussian(draw, 1))});
    }
    return runs;
  };
  std::size_t with_a_finding = 0;
  std::size_t alone = 0;
  for (std::uint64_t experiment = 0; experiment < kExperiments; ++experiment) {
    const std::vector<RunScore> first = play(experiment, 0);
    std::vector<Comparison> comparisons = {Compare(first, play(experiment, 1), 120, experiment),
                                           Compare(first, play(experiment, 2), 120, experiment)};
    CorrectTogether(comparisons);
    const bool found = std::ranges::any_of(comparisons, [](const Comparison& each) {
      return OnSuccess(each, 0.05) != Verdict::kNoDifferenceShown ||
             OnTime(each, 0.05) != Verdict::kNoDifferenceShown;
    });
    if (found) ++with_a_finding;
    if (comparisons[0].times.p <= 0.05) ++alone;
  }
  // 4.5 standard deviations of the binomial distribution: 1 in 300,000 where the level holds.
  const double bound = kExperiments * 0.05 + 4.5 * std::sqrt(kExperiments * 0.05 * 0.95);
  EXPECT_LE(static_cast<double>(with_a_finding), bound);
  EXPECT_LE(static_cast<double>(alone), bound);
  EXPECT_GE(with_a_finding, kExperiments / 100) << "tests that find nothing at all prove nothing";
}

TEST(ComparisonTest, Handicap_IsFoundDespiteTheSpreadOfScenarios) {
  Comparison slow = Compare(Runs(1, 0, 0), Runs(2, 4, 0), 300, 1);
  EXPECT_EQ(OnTime(slow, 0.05), Verdict::kFirstBetter);
  EXPECT_LT(slow.difference.high, 0);
  EXPECT_EQ(OnSuccess(slow, 0.05), Verdict::kNoDifferenceShown);
  Comparison clumsy = Compare(Runs(1, 0, 0.4), Runs(2, 0, 0), 300, 1);
  EXPECT_EQ(OnSuccess(clumsy, 0.05), Verdict::kSecondBetter);
}

TEST(ComparisonTest, Failures_AreNeverDropped) {
  const std::vector<RunScore> first = {{true, 10}, {false, 0}};
  const std::vector<RunScore> second = {{true, 20}, {true, 30}};
  const Comparison comparison = Compare(first, second, 100, 1);
  EXPECT_DOUBLE_EQ(comparison.first_par2, (10 + 200) / 2.0);
  EXPECT_DOUBLE_EQ(comparison.second_par2, 25);
  EXPECT_DOUBLE_EQ(comparison.difference.mean, (-10 + 70) / 2.0);
  EXPECT_EQ(comparison.discordant.only_second, 1U);
  EXPECT_EQ(comparison.pairs, 2U);
}

}  // namespace
}  // namespace latchwork::compare
