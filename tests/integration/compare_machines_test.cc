// SPDX-License-Identifier: BSD-3-Clause
//
// An experiment gives the same results.sqlite, byte for byte, whoever makes its runs and whatever
// dies meanwhile: under SLURM, under Open MPI, and where it is killed half-way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>

#include "apps/compare/experiment/experiment.h"
#include "apps/compare/folder/result_folder.h"
#include "apps/compare/runs/run_queue.h"
#include "tests/integration/run_command.h"
#include "tests/integration/towers.h"

namespace latchwork::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::KilledBySignal;
using ::testing::Not;

class KilledExperimentTest : public TowersTest {
 protected:
  /// Makes runs as the command does, and dies when `lines` of them are logged.
  [[noreturn]] void MakeRunsAndDie(int lines) const {
    std::filesystem::current_path(scratch_.path());
    const auto experiment = compare::ReadExperiment("towers.xml").experiment;
    compare::ResultFolder folder(*experiment, "killed");
    compare::QueueOptions queue;
    queue.launch = {LATCHWORK_BINARY_DIR "/bin/latchwork", {}};
    queue.limits = experiment->limits;
    queue.jobs = 2;
    queue.on_done = [&](const compare::RunRecord& record) {
      const bool kept = folder.Keep(record);
      if (--lines == 0) raise(SIGKILL);
      return kept;
    };
    std::atomic<bool> stop = false;
    MakeRuns(folder.Missing(), queue, stop);
    std::_Exit(1);
  }
};

TEST_F(KilledExperimentTest, GoesOnWhereItWasKilled) {
  WriteExperiment("seeds=\"1-3\"");
  ASSERT_EQ(Compare({"--out", "whole"}).exit_code, 0);
  EXPECT_EXIT(MakeRunsAndDie(4), KilledBySignal(SIGKILL), "");
  EXPECT_EQ(CountLines("killed/runs.jsonl"), 4U);
  EXPECT_EXIT(MakeRunsAndDie(1), KilledBySignal(SIGKILL), "");
  EXPECT_EQ(CountLines("killed/runs.jsonl"), 5U);
  const CommandResult last = Compare({"--out", "killed"});
  EXPECT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(CountLines("killed/runs.jsonl"), 9U);
  EXPECT_EQ(Bytes("killed"), Bytes("whole"));
}

class SlurmTest : public TowersTest {
 protected:
  /// Makes an sbatch that runs what it is given at once, all tasks of an array, and keeps its
  /// arguments.
  void WriteSbatch() const {
    WriteText(scratch_.path() / "sbatch",
              "#!/bin/sh\n"
              "echo \"$*\" >>sbatch.log\n"
              "for script in \"$@\"; do :; done\n"
              "last=$(sed -n 's/^#SBATCH --array=1-//p' \"$script\")\n"
              "task=${last:-1}\n"
              "while [ \"$task\" -ge 1 ]; do\n"
              "  SLURM_ARRAY_TASK_ID=$task sh \"$script\" >&2 || exit\n"
              "  task=$((task - 1))\n"
              "done\n"
              "echo '17;cluster'\n");
    std::filesystem::permissions(scratch_.path() / "sbatch", std::filesystem::perms::owner_all);
  }
};

TEST_F(SlurmTest, SubmittedShardsAndTheirMerging_GiveTheSameBytes) {
  WriteExperiment("seeds=\"1-3\"");
  WriteSbatch();
  ASSERT_EQ(Compare({"--out", "whole"}).exit_code, 0);
  const CommandResult written = Compare({"--out", "in two parts", "--slurm", "2"});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  EXPECT_THAT(written.out, HasSubstr("sh 'in two parts/slurm/submit.sh'"));
  EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "in two parts/runs.jsonl"));
  const CommandResult submitted =
      RunShell("PATH=$PWD:$PATH sh 'in two parts/slurm/submit.sh' --time=60", scratch_.path());
  EXPECT_EQ(submitted.exit_code, 0) << submitted.err;
  EXPECT_EQ(CountLines("in two parts/shards/1/runs.jsonl"), 6U);
  EXPECT_EQ(CountLines("in two parts/shards/2/runs.jsonl"), 3U);
  EXPECT_EQ(Bytes("in two parts"), Bytes("whole"));
  const std::string asked = ReadText(scratch_.path() / "sbatch.log");
  EXPECT_THAT(asked, HasSubstr("--parsable --output=in two parts/slurm/shard-%a.log --time=60"));
  EXPECT_THAT(asked, HasSubstr("--dependency=afterok:17 --kill-on-invalid-dep=yes"));
}

TEST_F(SlurmTest, MoreShardsThanParts_AreNotWritten) {
  WriteExperiment("seeds=\"1-3\"");
  ASSERT_EQ(Compare({"--out", "all", "--slurm", "40"}).exit_code, 0);
  EXPECT_THAT(ReadText(scratch_.path() / "all/slurm/shard.sbatch"), HasSubstr("--array=1-3\n"));
  EXPECT_EQ(Compare({"--out", "all", "--slurm"}).exit_code, 0);
  EXPECT_EQ(Compare({"--out", "all", "--slurm", "0"}).exit_code, 2);
}

class MpiTest : public TowersTest {
 protected:
  void SetUp() override {
    const bool built = std::filesystem::exists(LATCHWORK_BINARY_DIR "/bin/latchwork-mpi");
    if (!built || RunShell("command -v mpirun", scratch_.path()).exit_code != 0) {
      GTEST_SKIP() << "there is no Open MPI";
    }
    WriteExperiment("seeds=\"1-3\"");
    WriteText(scratch_.path() / "die.sh",
              "latchwork-mpi \"$@\" & worker=$!\n"
              "until [ -n \"$(cat /proc/$worker/task/*/children)\" ]; do kill -0 $worker || exit; "
              "done\n"
              "kill -KILL $worker; wait $worker\n");
  }
  CommandResult Mpi(const std::string& arguments) const {
    return RunShell(
        "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1\n"
        "exec mpirun --oversubscribe " +
            arguments,
        scratch_.path());
  }
};

constexpr const char* kLatchwork = " latchwork-mpi towers.xml --quiet ";

TEST_F(MpiTest, FourRanks_GiveTheSameBytes) {
  ASSERT_EQ(Compare({"--out", "whole"}).exit_code, 0);
  const CommandResult result = Mpi(std::string("-n 4") + kLatchwork + "--out all");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, ReadText(scratch_.path() / "whole/report.txt"));
  EXPECT_EQ(Bytes("all"), Bytes("whole"));
}

TEST_F(MpiTest, WorkerThatDies_IsReplaced) {
  WriteExperiment("seeds=\"1-12\"");  // so many that worker 3 gets one
  ASSERT_EQ(Compare({"--out", "whole"}).exit_code, 0);
  const std::string rest = "towers.xml --quiet --out all --patience 2";
  const CommandResult result =
      Mpi("--enable-recovery -n 3 latchwork-mpi " + rest + " : -n 1 sh die.sh " + rest);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err,
              HasSubstr("worker 3 is silent; another one makes its run: latchwork run"));
  EXPECT_EQ(CountLines("all/runs.jsonl"), 36U);
  EXPECT_EQ(Bytes("all"), Bytes("whole"));
}

TEST_F(MpiTest, WorkerThatDiesWithoutRecovery_LeavesAFolderToGoOnFrom) {
  ASSERT_EQ(Compare({"--out", "whole"}).exit_code, 0);
  const std::string rest = "towers.xml --quiet --out all";
  const CommandResult result = Mpi("-n 3 latchwork-mpi " + rest + " : -n 1 sh die.sh " + rest);
  EXPECT_NE(result.exit_code, 0);
  EXPECT_EQ(Mpi(std::string("-n 2") + kLatchwork + "--out all").exit_code, 0);
  EXPECT_EQ(Bytes("all"), Bytes("whole"));
}

TEST_F(MpiTest, RunThatCannotBegin_EndsTheExperiment) {
  std::string text = Experiment("seeds=\"1-3\"");
  text.replace(text.find("world.slip"), 10, "world.slop");
  WriteText(scratch_.path() / "towers.xml", text);
  const CommandResult result = Mpi(std::string("-n 3") + kLatchwork + "--out all");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("towers.xml:"));
  EXPECT_THAT(ReadText(scratch_.path() / "all/runs.jsonl"), Not(HasSubstr("slipping")));
}

TEST_F(MpiTest, OnlyTheMaster_NeedsTheExperiment) {
  ASSERT_EQ(Compare({"--out", "whole"}).exit_code, 0);
  const CommandResult result = Mpi(
      "-n 1 latchwork-mpi towers.xml --quiet --out all : -n 2 latchwork-mpi elsewhere.xml --quiet");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Bytes("all"), Bytes("whole"));
}

TEST_F(MpiTest, MissingExperiment_SendsTheWorkersAway) {
  const CommandResult result = Mpi("-n 3 latchwork-mpi elsewhere.xml --quiet");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("elsewhere.xml"));
  EXPECT_THAT(result.err, Not(HasSubstr("the master is silent")));
}

TEST_F(MpiTest, OneProcess_HasNoWorker) {
  const CommandResult result = Mpi(std::string("-n 1") + kLatchwork + "--out all");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("there is no worker; start it with mpirun and -n 2 or more"));
}

}  // namespace
}  // namespace latchwork::testing
