// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <string>

#include "apps/compare/report/findings.h"
#include "apps/compare/runs/run_record.h"
#include "apps/compare/storage/run_log.h"
#include "tests/temporary_folder.h"

namespace latchwork::compare {
namespace {

const PlannedRun kRun = {{"floor", "pttp", 7}, {"run", "a file.xml", "--seed", "7"}};

RunRecord JudgeOutput(const std::string& output, const std::string& errors = "") {
  process::ChildResult child;
  child.end = process::ChildResult::End::kExited;
  child.output = output;
  child.errors = errors;
  return Judge(kRun, child);
}

TEST(RunRecordTest, OutcomesOfSummaries) {
  EXPECT_EQ(JudgeOutput(R"({"outcome":"reached","collisions":0})").outcome, Outcome::kReached);
  EXPECT_EQ(JudgeOutput(R"({"outcome":"reached","collisions":1})").outcome, Outcome::kCollision);
  EXPECT_EQ(JudgeOutput(R"({"outcome":"not reached"})").outcome, Outcome::kNotReached);
  EXPECT_EQ(JudgeOutput(R"({"outcome":"failed"})").outcome, Outcome::kFailed);
}

TEST(RunRecordTest, TimeIsTheWorldsElseThatOfTheTicks) {
  EXPECT_EQ(
      JudgeOutput(R"({"outcome":"reached","ticks":40,"tick_s":0.25,"measures":{"time_s":7.5}})")
          .time_s,
      7.5);
  EXPECT_EQ(JudgeOutput(R"({"outcome":"reached","ticks":40,"tick_s":0.25,"measures":{"time_s":0}})")
                .time_s,
            0.0);
  EXPECT_EQ(
      JudgeOutput(R"({"outcome":"reached","ticks":40,"tick_s":0.25,"measures":{"collisions":0}})")
          .time_s,
      10.0);
}

TEST(RunRecordTest, RunThatDidNotBegin_IsInvalidAndSaysWhy) {
  const RunRecord record =
      JudgeOutput(R"({"outcome":"did not begin","measures":{},"errors":"a.xml:1:2: no\n  hint"})");
  EXPECT_EQ(record.outcome, Outcome::kInvalid);
  EXPECT_EQ(record.message, "a.xml:1:2: no");
}

TEST(RunRecordTest, ProcessesThatDoNotEndWell) {
  process::ChildResult child;
  child.end = process::ChildResult::End::kSignalled;
  child.code = SIGSEGV;
  EXPECT_EQ(Judge(kRun, child).outcome, Outcome::kCrashed);
  child.end = process::ChildResult::End::kTimedOut;
  EXPECT_EQ(Judge(kRun, child).outcome, Outcome::kTimedOut);
  EXPECT_EQ(JudgeOutput("", "internal error: std::bad_alloc").outcome, Outcome::kCrashed);
  EXPECT_EQ(JudgeOutput(R"({"outcome":3})").outcome, Outcome::kCrashed);
  EXPECT_EQ(JudgeOutput(R"({"outcome":"reached","layers":[3]})").outcome, Outcome::kCrashed);
  child.end = process::ChildResult::End::kExited;
  child.code = 5;
  EXPECT_EQ(Judge(kRun, child).outcome, Outcome::kCrashed);
  child.code = 3;
  EXPECT_EQ(Judge(kRun, child).outcome, Outcome::kInvalid);
}

TEST(RunRecordTest, WhatALimitEnded_IsRepeatedWithinTheLimits) {
  RunRecord record;
  record.command = "latchwork run a.xml --seed 7";
  record.outcome = Outcome::kTimedOut;
  const RunLimits limits{60, 2};
  EXPECT_EQ(RepeatOf(record, limits), "(ulimit -v 2048; timeout 60 latchwork run a.xml --seed 7)");
  record.outcome = Outcome::kCollision;
  EXPECT_EQ(RepeatOf(record, limits), record.command);
}

TEST(RunRecordTest, WorldWithoutTime_IsTimedByItsTicks) {
  EXPECT_EQ(JudgeOutput(R"({"outcome":"reached","ticks":30,"tick_s":0.5})").time_s, 15.0);
  EXPECT_EQ(JudgeOutput(R"({"outcome":"reached","ticks":30,"tick_s":0.5,"measures":{"time_s":4}})")
                .time_s,
            4.0);
}

TEST(RunRecordTest, CommandIsQuotedForAShell) {
  EXPECT_EQ(JudgeOutput("{}").command, "latchwork run 'a file.xml' --seed 7");
}

RunRecord Record(const std::string& contender, std::uint64_t seed, Outcome outcome, double time_s) {
  RunRecord record;
  record.key = {"floor", contender, seed};
  record.outcome = outcome;
  record.message = "a \"b\"";
  record.command = "latchwork run";
  record.time_s = time_s;
  record.duration_s = 600;
  record.layers = {{"avoid", "pttp", 3, 1.5, 1, 2, 0, 10, 8, 20}};
  record.trajectory = "1 2.5,3 4.25,3;2 9,9";
  return record;
}

TEST(RunRecordTest, LineKeepsEverything) {
  const RunRecord record = Record("pttp", 3, Outcome::kTimedOut, 12.3);
  EXPECT_EQ(FromLine(ToLine(record)), record);
  EXPECT_FALSE(FromLine("[]"));
  EXPECT_FALSE(FromLine("{}"));
  EXPECT_FALSE(FromLine(ToLine(record).substr(0, 50)));
}

TEST(RunLogTest, TwoWritersAreRefused) {
  const test::TemporaryFolder folder;
  RunLog first(folder.path() / "runs.jsonl");
  EXPECT_EQ(first.problem(), "");
  EXPECT_TRUE(first.Add(Record("pttp", 1, Outcome::kReached, 1)));
  EXPECT_THAT(RunLog(folder.path() / "runs.jsonl").problem(),
              ::testing::HasSubstr("another process"));
}

TEST(RunLogTest, ReadingLeavesATornLineWhereItIs) {
  const test::TemporaryFolder folder;
  const std::string line = ToLine(Record("pttp", 1, Outcome::kReached, 1)) + "\n";
  const auto file = folder.Write("runs.jsonl", line + line.substr(0, 20));
  EXPECT_EQ(ReadRunLog(file).runs.size(), 1U);
  EXPECT_EQ(std::filesystem::file_size(file), line.size() + 20);
}

TEST(RunLogTest, RunThatCouldNotBegin_IsNoneToGoOnFrom) {
  const test::TemporaryFolder folder;
  const std::string line = ToLine(Record("pttp", 1, Outcome::kInvalid, 0)) + "\n";
  EXPECT_NE(ReadRunLog(folder.Write("runs.jsonl", line)).problem, "");
}

TEST(FindingsTest, AgentThatAlwaysFails_IsSlowerAndReachesLess) {
  Experiment experiment;
  experiment.last_seed = 12;
  experiment.scenarios = {{"floor", "floor.xml"}};
  experiment.contenders = {{"good", {}, {}}, {"bad", {}, {}}};
  std::map<RunKey, RunRecord> records;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    for (const RunRecord& record :
         {Record("good", seed, Outcome::kReached, 40), Record("bad", seed, Outcome::kCrashed, 0)}) {
      records.emplace(record.key, record);
    }
  }
  const Findings findings = Evaluate(experiment, records);
  ASSERT_EQ(findings.duels.size(), 1U);
  EXPECT_EQ(OnSuccess(findings.duels[0].comparison, 0.05), Verdict::kFirstBetter);
  EXPECT_EQ(OnTime(findings.duels[0].comparison, 0.05), Verdict::kFirstBetter);
  EXPECT_EQ(findings.failures.size(), 12U);
}

TEST(RunPlanTest, SeedOffset_IsOfTheWorldNotOfThePair) {
  Experiment experiment;
  experiment.scenarios = {{"a", "a.xml"}};
  experiment.contenders = {{"one", {}, {}}, {"two", {}, {}, 1000}};
  const std::vector<PlannedRun> runs = PlanRuns(experiment);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[1].key.seed, 1U);
  EXPECT_EQ(CommandOf(runs[1]), "latchwork run a.xml --seed 1001");
}

TEST(RunPlanTest, AgentsOfASeedStayInOneShard) {
  Experiment experiment;
  experiment.last_seed = 4;
  experiment.scenarios = {{"a", "a.xml"}, {"b", "b.xml"}};
  experiment.contenders = {{"one", {}, {}}, {"two", {}, {}}};
  for (const PlannedRun& run : PlanRuns(experiment, {1, 2})) EXPECT_EQ(run.key.scenario, "b");
  EXPECT_EQ(PlanRuns(experiment, {0, 2}).size() + PlanRuns(experiment, {1, 2}).size(), 16U);
}

}  // namespace
}  // namespace latchwork::compare
