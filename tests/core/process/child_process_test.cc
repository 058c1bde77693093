// SPDX-License-Identifier: BSD-3-Clause
#include "core/process/child_process.h"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <string>

namespace latchwork::process {
namespace {

using End = ChildResult::End;

ChildResult Shell(const std::string& script, const Limits& limits = {}) {
  const std::atomic<bool> stop = false;
  return RunChild("/bin/sh", {"-c", script}, limits, stop);
}

TEST(ChildProcessTest, KeepsOutputErrorsAndCode) {
  const ChildResult result = Shell("echo out; echo err >&2; exit 3");
  EXPECT_EQ(result.end, End::kExited);
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(result.output, "out\n");
  EXPECT_EQ(result.errors, "err\n");
}

TEST(ChildProcessTest, Signal_IsToldFromACode) {
  const ChildResult result = Shell("kill -SEGV $$");
  EXPECT_EQ(result.end, End::kSignalled);
  EXPECT_EQ(result.code, SIGSEGV);
}

TEST(ChildProcessTest, WallTime_EndsTheChildAndWhatItStarted) {
  const ChildResult result = Shell("cat /dev/zero >/dev/null & wait", {0.05, 4096});
  EXPECT_EQ(result.end, End::kTimedOut);
}

TEST(ChildProcessTest, WallTime_EndsAChildThatClosedItsOutput) {
  const ChildResult result = Shell("exec cat /dev/zero >/dev/null 2>&1", {0.05, 4096});
  EXPECT_EQ(result.end, End::kTimedOut);
}

TEST(ChildProcessTest, Stop_EndsIt) {
  const std::atomic<bool> stop = true;
  EXPECT_EQ(RunChild("/bin/cat", {"/dev/zero"}, {}, stop).end, End::kStopped);
}

TEST(ChildProcessTest, EndlessOutput_IsCutNotKept) {
  const ChildResult result = Shell("head -c 20000000 /dev/zero");
  EXPECT_EQ(result.end, End::kExited);
  EXPECT_LE(result.output.size(), (16U << 20U) + 4096U);
}

TEST(ChildProcessTest, MissingProgram_IsNotStarted) {
  const std::atomic<bool> stop = false;
  EXPECT_EQ(RunChild("/no/such/program", {}, {}, stop).end, End::kNotStarted);
}

TEST(ChildProcessTest, EndThatTheSystemDoesNotTell_IsNoSuccess) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  const ChildResult result = Shell("exit 3");
  std::signal(SIGCHLD, before);
  EXPECT_EQ(result.end, End::kNotStarted);
  EXPECT_NE(result.errors, "");
}

TEST(ChildProcessTest, Input_IsReadToItsEnd) {
  const std::atomic<bool> stop = false;
  const std::string input(3'000'000, 'x');
  EXPECT_EQ(RunChild("/bin/cat", {}, {}, stop, input).output, input);
}

TEST(ChildProcessTest, InputThatNobodyReads_IsDropped) {
  const std::atomic<bool> stop = false;
  const ChildResult result = RunChild("/bin/true", {}, {}, stop, std::string(3'000'000, 'x'));
  EXPECT_EQ(result.end, End::kExited);
  EXPECT_EQ(result.code, 0);
}

}  // namespace
}  // namespace latchwork::process
