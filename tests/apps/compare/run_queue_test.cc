// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/run_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "apps/compare/folder/result_folder.h"
#include "apps/compare/storage/run_log.h"
#include "tests/apps/compare/stand_in.h"
#include "tests/temporary_folder.h"

namespace latchwork::compare {
namespace {

Experiment TwoAgents(std::uint64_t seeds) {
  Experiment experiment;
  experiment.name = "many";
  experiment.last_seed = seeds;
  experiment.scenarios = {{"floor", "floor.xml"}};
  experiment.contenders = {{"one", {}, {}}, {"other", {}, {}}};
  return experiment;
}

TEST(RunQueueTest, ManyRunsAtATime_NoneIsLostOrMadeTwice) {
  const test::TemporaryFolder scratch;
  const Experiment experiment = TwoAgents(100);
  ResultFolder folder(experiment, scratch.path());
  std::multiset<RunKey> ended;
  QueueOptions queue;
  queue.launch = StandIn();
  queue.jobs = 4;
  queue.on_done = [&](const RunRecord& record) {
    ended.insert(record.key);
    return folder.Keep(record);
  };
  std::atomic<bool> stop = false;
  MakeRuns(folder.Missing(), queue, stop);
  EXPECT_FALSE(stop);
  EXPECT_EQ(ended.size(), 200U);
  EXPECT_TRUE(folder.Missing().empty());
  const LoggedRuns logged = ReadRunLog(scratch.path() / "runs.jsonl");
  EXPECT_EQ(logged.runs.size(), 200U);
  for (const auto& [key, record] : logged.runs) {
    EXPECT_EQ(record.time_s, static_cast<double>(key.seed));
    EXPECT_EQ(ended.count(key), 1U);
  }
}

TEST(RunQueueTest, WhoeverKeepsTheRuns_EndsTheWork) {
  const Experiment experiment = TwoAgents(100);
  std::size_t told = 0;
  QueueOptions queue;
  queue.launch = StandIn();
  queue.on_done = [&](const RunRecord& /*record*/) { return ++told < 3; };
  std::atomic<bool> stop = false;
  MakeRuns(PlanRuns(experiment), queue, stop);
  EXPECT_TRUE(stop);
  EXPECT_EQ(told, 3U);
}

}  // namespace
}  // namespace latchwork::compare
