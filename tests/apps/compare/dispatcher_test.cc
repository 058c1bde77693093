// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/dispatch/dispatcher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace latchwork::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class DispatcherTest : public ::testing::Test {
 protected:
  static std::vector<PlannedRun> Runs(std::uint64_t count) {
    std::vector<PlannedRun> runs;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
      runs.push_back({{"floor", "pttp", seed}, {"run", "--seed", std::to_string(seed)}});
    }
    return runs;
  }
  Dispatcher Make(std::uint64_t runs, int workers) {
    Dispatcher::Options options;
    options.workers = workers;
    options.patience_seconds = 10;
    options.endurance_seconds = 40;
    options.on_done = [this](const RunRecord& record) {
      done_.push_back(record.key.seed);
      return done_.size() < most_;
    };
    options.on_loss = [this](const std::string& text) { losses_.push_back(text); };
    return {Runs(runs), std::move(options), 0};
  }
  /// The seed of the run that a worker is given; 0 for any other answer.
  static std::uint64_t Given(const std::string& answer) {
    const auto task = TaskFromText(answer);
    return task ? task->run.key.seed : 0;
  }
  static std::string Record(std::uint64_t seed) {
    RunRecord record;
    record.key = {"floor", "pttp", seed};
    record.outcome = Outcome::kReached;
    record.command = CommandOf(Runs(seed).back());
    return ToLine(record);
  }

  std::vector<std::uint64_t> done_;
  std::vector<std::string> losses_;
  std::size_t most_ = 100;
};

TEST_F(DispatcherTest, EveryRunIsGivenOnceAndAllAreSentAwayTogether) {
  Dispatcher dispatcher = Make(3, 2);
  EXPECT_EQ(Given(dispatcher.Answer(1, kIdle, 0)), 1U);
  EXPECT_EQ(Given(dispatcher.Answer(2, kIdle, 0)), 2U);
  EXPECT_EQ(dispatcher.Answer(2, kBusy, 1), kGoOn);
  EXPECT_EQ(Given(dispatcher.Answer(2, Record(2), 2)), 3U);
  EXPECT_EQ(dispatcher.Answer(1, Record(1), 2), kWait);
  EXPECT_EQ(dispatcher.Answer(2, Record(3), 3), kWait);
  EXPECT_FALSE(dispatcher.finished());
  EXPECT_EQ(dispatcher.Answer(1, kIdle, 3), kStop);
  EXPECT_EQ(dispatcher.Answer(2, kIdle, 3), kStop);
  EXPECT_TRUE(dispatcher.finished());
  EXPECT_TRUE(dispatcher.together());
  EXPECT_THAT(done_, ElementsAre(2, 1, 3));
}

TEST_F(DispatcherTest, SilentWorker_IsReplacedAndNobodyWaitsForIt) {
  Dispatcher dispatcher = Make(2, 2);
  EXPECT_EQ(Given(dispatcher.Answer(1, kIdle, 0)), 1U);
  EXPECT_EQ(Given(dispatcher.Answer(2, kIdle, 0)), 2U);
  EXPECT_EQ(dispatcher.Answer(2, Record(2), 9), kWait);
  dispatcher.Look(10);
  EXPECT_EQ(dispatcher.Answer(2, kIdle, 10), kWait);
  dispatcher.Look(10.5);
  EXPECT_THAT(losses_, ElementsAre(HasSubstr("worker 1 is silent; another one makes its run: "
                                             "latchwork run --seed 1")));
  EXPECT_EQ(Given(dispatcher.Answer(2, kIdle, 11)), 1U);
  EXPECT_EQ(dispatcher.Answer(2, Record(1), 12), kLeave);
  EXPECT_TRUE(dispatcher.finished());
  EXPECT_FALSE(dispatcher.together());
  EXPECT_EQ(dispatcher.missing(), 0U);
}

TEST_F(DispatcherTest, LostWorkerSpeaksAgain_ItsRecordCountsOnce) {
  Dispatcher dispatcher = Make(2, 2);
  EXPECT_EQ(Given(dispatcher.Answer(1, kIdle, 0)), 1U);
  EXPECT_EQ(Given(dispatcher.Answer(2, kIdle, 9)), 2U);
  dispatcher.Look(11);
  EXPECT_EQ(Given(dispatcher.Answer(2, Record(2), 11)), 1U);
  EXPECT_EQ(dispatcher.Answer(1, kBusy, 12), kGoOn);
  EXPECT_EQ(dispatcher.Answer(1, Record(1), 13), kWait);
  EXPECT_EQ(dispatcher.Answer(2, kBusy, 13), kDrop);
  EXPECT_EQ(dispatcher.Answer(2, Record(1), 13), kStop);
  EXPECT_EQ(dispatcher.Answer(1, kIdle, 13), kStop);
  EXPECT_TRUE(dispatcher.together());
  EXPECT_THAT(done_, ElementsAre(2, 1));
}

TEST_F(DispatcherTest, WorkerLostAtTheEnd_IsNotWaitedFor) {
  Dispatcher dispatcher = Make(1, 2);
  EXPECT_EQ(Given(dispatcher.Answer(1, kIdle, 0)), 1U);
  EXPECT_EQ(dispatcher.Answer(1, Record(1), 1), kWait);
  EXPECT_EQ(dispatcher.Answer(2, kIdle, 1), kStop);
  dispatcher.Look(12);
  EXPECT_TRUE(dispatcher.finished());
  EXPECT_FALSE(dispatcher.together());
}

TEST_F(DispatcherTest, EverybodyLost_LeavesRunsMissing) {
  Dispatcher dispatcher = Make(2, 2);
  EXPECT_EQ(Given(dispatcher.Answer(1, kIdle, 0)), 1U);
  EXPECT_FALSE(dispatcher.finished());
  dispatcher.Look(11);
  EXPECT_FALSE(dispatcher.finished());
  dispatcher.Look(41);
  EXPECT_TRUE(dispatcher.finished());
  EXPECT_FALSE(dispatcher.together());
  EXPECT_EQ(dispatcher.missing(), 2U);
  EXPECT_EQ(losses_.size(), 2U);
}

TEST_F(DispatcherTest, WorkIsEnded_WhenWhoKeepsTheRunsSaysSo) {
  most_ = 1;
  Dispatcher dispatcher = Make(9, 2);
  EXPECT_EQ(Given(dispatcher.Answer(1, kIdle, 0)), 1U);
  EXPECT_EQ(Given(dispatcher.Answer(2, kIdle, 0)), 2U);
  EXPECT_EQ(dispatcher.Answer(1, Record(1), 1), kWait);
  EXPECT_EQ(dispatcher.Answer(2, kBusy, 1), kDrop);
  EXPECT_EQ(dispatcher.Answer(2, kIdle, 1), kStop);
  EXPECT_EQ(dispatcher.Answer(1, kIdle, 1), kStop);
  EXPECT_EQ(dispatcher.missing(), 8U);
}

TEST_F(DispatcherTest, WhatIsNoRecordOfAnExpectedRun_IsNotTaken) {
  Dispatcher dispatcher = Make(1, 1);
  std::string strange = Record(1);
  strange.replace(strange.find("--seed 1"), 8, "--seed 7");
  for (const std::string& said : {std::string("nonsense"), Record(2), strange}) {
    EXPECT_EQ(Given(dispatcher.Answer(1, said, 0)), 1U) << said;
  }
  EXPECT_THAT(done_, IsEmpty());
}

TEST(TaskTest, TravelsAsText) {
  const Task task{{{"floor", "pttp", 7}, {"run", "a \"file\".xml", "--seed", "7"}}, {1.5, 99}};
  const auto back = TaskFromText(ToText(task));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->run.key, task.run.key);
  EXPECT_EQ(back->run.arguments, task.run.arguments);
  EXPECT_EQ(back->limits.wall_seconds, 1.5);
  EXPECT_EQ(back->limits.memory_mb, 99U);
  EXPECT_FALSE(TaskFromText(kWait));
  EXPECT_FALSE(TaskFromText("{\"scenario\":1}"));
}

}  // namespace
}  // namespace latchwork::compare
