// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/ompl_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "core/process/child_process.h"
#include "core/process/spawn.h"
#include "tests/apps/compare/trial.h"
#include "tests/temporary_folder.h"

namespace latchwork::compare {
namespace {

using ::testing::HasSubstr;

std::string Shell(const std::string& script) {
  const std::atomic<bool> stop = false;
  const process::ChildResult result =
      process::RunChild("/bin/sh", {"-c", script}, {50, 1U << 20U}, stop);
  EXPECT_EQ(result.code, 0) << result.errors;
  return result.output;
}

TEST(OmplLogTest, EveryRunIsALine) {
  const std::string log = ToOmplLog(Trial().Input(), "floor");
  EXPECT_THAT(log, HasSubstr("Experiment trial-floor\n"));
  EXPECT_THAT(log,
              HasSubstr("\nslow\n0 common properties\n9 properties for each run\ntime REAL\n"));
  EXPECT_THAT(log, HasSubstr("12 runs\n123; 1; 0; 12.5; 0; 10; 25; 0; 1; \n"));
  EXPECT_THAT(log, HasSubstr("600; 0; 1; nan; 0; 10; 25; 0; 12; \n.\n"));
}

TEST(OmplLogTest, RunThatCrashed_TakesTheWholeDuration) {
  Trial trial;
  RunRecord& run = trial.records.at({"floor", "bad", 12});
  run.outcome = Outcome::kCrashed;
  run.duration_s = 0;
  EXPECT_THAT(ToOmplLog(trial.Input(), "floor"), HasSubstr("600; 0; 5; nan; 0; 10; 25; 0; 12; \n"));
}

TEST(OmplLogTest, StatisticsOfOmplMakeADatabaseOfIt) {
  if (process::FindProgram("ompl_benchmark_statistics").empty()) {
    GTEST_SKIP() << "ompl-demos is not installed";
  }
  const test::TemporaryFolder folder;
  const auto log = folder.Write("ompl-floor.log", ToOmplLog(Trial().Input(), "floor"));
  const std::string database = (folder.path() / "arena.db").string();
  Shell("ompl_benchmark_statistics '" + log.string() + "' -d '" + database + "' 2>&1");
  const std::string query =
      "SELECT e.name, e.version, e.timelimit, e.runcount, p.name, p.settings, count(*), "
      "sum(solved), group_concat(DISTINCT s.description), total(time), count(solution_length) "
      "FROM experiments e JOIN runs r ON r.experimentid = e.id "
      "JOIN plannerConfigs p ON p.id = r.plannerid "
      "JOIN enums s ON s.name = 'status' AND s.value = r.status GROUP BY p.id";
  const std::string rows = Shell("python3 -c \"import sqlite3\nfor row in sqlite3.connect('" +
                                 database + "').execute(\\\"" + query + "\\\"): print(row)\"");
  EXPECT_EQ(rows,
            "('trial-floor', 'latchwork 1.2.3', 600.0, 12, 'good', '', 12, 12, 'reached', 1434.0, "
            "12)\n"
            "('trial-floor', 'latchwork 1.2.3', 600.0, 12, 'twin', '', 12, 12, 'reached', 1434.0, "
            "12)\n"
            "('trial-floor', 'latchwork 1.2.3', 600.0, 12, 'slow', '', 12, 12, 'reached', 1674.0, "
            "12)\n"
            "('trial-floor', 'latchwork 1.2.3', 600.0, 12, 'bad', 'fragment = bad.xml\\n;set = "
            "avoid.gain=0\\n;', 12, 0, 'collision', 7200.0, 0)\n");
}

}  // namespace
}  // namespace latchwork::compare
