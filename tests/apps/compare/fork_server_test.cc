// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/fork_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "apps/compare/report/floor_plan.h"
#include "apps/compare/runs/run_queue.h"
#include "tests/apps/compare/stand_in.h"

namespace latchwork::compare {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

Task TaskOf(std::uint64_t seed) {
  Task task;
  task.run = {{"floor", "one", seed}, {"run", "floor.xml", "--seed", std::to_string(seed)}};
  return task;
}

RunRecord Make(ForkServer& server, std::uint64_t seed) {
  const std::atomic<bool> stop = false;
  return *MakeRun(server, TaskOf(seed), stop);
}

TEST(ForkServerTest, OneProcess_MakesAllRuns) {
  ForkServer server(StandIn("read -r task\n" + std::string(kAnswer) + "read -r task\n" + kAnswer +
                            "read -r task\n" + kAnswer));
  for (const std::uint64_t seed : {3U, 1U, 2U}) {
    const RunRecord record = Make(server, seed);
    EXPECT_EQ(record.outcome, Outcome::kReached);
    EXPECT_EQ(record.time_s, static_cast<double>(seed));
  }
}

TEST(ForkServerTest, DeadServer_IsACrashOfItsRunAndIsReplaced) {
  ForkServer server(StandIn("read -r task\n" + std::string(kAnswer) +
                            "read -r task; echo 'half of it' >&2; echo 'broken' >&2; kill -9 $$"));
  EXPECT_EQ(Make(server, 1).outcome, Outcome::kReached);
  const RunRecord crashed = Make(server, 2);
  EXPECT_EQ(crashed.outcome, Outcome::kCrashed);
  EXPECT_EQ(crashed.key, (RunKey{"floor", "one", 2}));
  EXPECT_EQ(crashed.command, "latchwork run floor.xml --seed 2");
  EXPECT_EQ(crashed.message, "the fork server was ended by signal 9: broken");
  EXPECT_EQ(Make(server, 3).outcome, Outcome::kReached);
}

TEST(ForkServerTest, ServerThatReadsNoMore_IsReplacedBeforeItCostsARun) {
  ForkServer server(StandIn("read -r task; exec <&-\n" + std::string(kAnswer)));
  EXPECT_EQ(Make(server, 1).outcome, Outcome::kReached);
  EXPECT_EQ(Make(server, 2).outcome, Outcome::kReached);
}

TEST(ForkServerTest, ServerThatIsNeverReady_CannotBeginARun) {
  ForkServer missing({"/no/such/program", {}});
  const RunRecord unstarted = Make(missing, 1);
  EXPECT_EQ(unstarted.outcome, Outcome::kInvalid);
  EXPECT_EQ(unstarted.message, "the fork server cannot be executed");
  ForkServer refusing({"/bin/sh", {"-c", "echo 'no such option' >&2; exit 2"}});
  EXPECT_EQ(Make(refusing, 1).message, "the fork server ended with exit code 2: no such option");
}

TEST(ForkServerTest, RecordOfAnotherRun_IsNotTaken) {
  ForkServer server(
      StandIn("read -r task; task='{\"scenario\":\"floor\",\"agent\":\"one\","
              "\"seed\":8,\"arguments'\n" +
              std::string(kAnswer)));
  EXPECT_THAT(Make(server, 1).message, HasSubstr("answers nonsense"));
}

TEST(ForkServerTest, Stop_EndsRunAndServer) {
  ForkServer server(StandIn("trap 'exit 0' TERM; read -r task; while :; do :; done"));
  const std::atomic<bool> stop = true;
  EXPECT_EQ(MakeRun(server, TaskOf(1), stop), std::nullopt);
  EXPECT_FALSE(server.is_busy());
}

TEST(ForkServerTest, Stop_EndsTheDrawingOfPlans) {
  Experiment experiment;
  experiment.scenarios = {{"floor", "floor.xml"}};
  experiment.contenders = {{"one", {}, {}}, {"other", {}, {}}};
  const Launch drawing = StandIn("read -r task; cat >/dev/null");
  const std::atomic<bool> stop = true;
  EXPECT_TRUE(DrawBuildings(experiment, drawing, stop).empty());
  const std::atomic<bool> go_on = false;
  EXPECT_EQ(DrawBuildings(experiment, StandIn(), go_on).count("floor"), 1U);
}

TEST(ForkServerTest, RunThatLasts_IsWaitedForAgain) {
  ForkServer server(StandIn("read -r task; cat >/dev/null"));
  server.Begin(TaskOf(1));
  EXPECT_EQ(server.Wait(1ms), std::nullopt);
  EXPECT_EQ(server.Wait(1ms), std::nullopt);
  EXPECT_TRUE(server.is_busy());
}

}  // namespace
}  // namespace latchwork::compare
