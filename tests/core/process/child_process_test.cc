// SPDX-License-Identifier: BSD-3-Clause
#include "core/process/child_process.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
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

ChildResult Copy(const std::function<int()>& work, const Limits& limits = {}) {
  const std::atomic<bool> stop = false;
  return RunForked(work, limits, stop);
}

TEST(ForkedRunTest, OutputErrorsAndCode_AreThoseOfTheWork) {
  const ChildResult result = Copy([] {
    std::fputs("out", stdout);
    std::fputs("err", stderr);
    return 3;
  });
  EXPECT_EQ(result.end, End::kExited);
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(result.output, "out");
  EXPECT_EQ(result.errors, "err");
}

TEST(ForkedRunTest, Memory_IsItsOwn) {
  int value = 1;
  EXPECT_EQ(Copy([&] { return value = 7; }).code, 7);
  EXPECT_EQ(value, 1);
}

TEST(ForkedRunTest, Crash_EndsTheCopyAlone) {
  EXPECT_EQ(Copy([]() -> int { std::abort(); }).code, SIGABRT);
  EXPECT_EQ(Copy([]() -> int { throw std::runtime_error("out"); }).end, End::kSignalled);
}

TEST(ForkedRunTest, WallTime_EndsIt) {
  const auto forever = []() -> int {
    while (true) sched_yield();
  };
  EXPECT_EQ(Copy(forever, {0.05, 4096}).end, End::kTimedOut);
  const std::atomic<bool> stop = true;
  EXPECT_EQ(RunForked(forever, {}, stop).end, End::kStopped);
}

TEST(ForkedRunTest, AddressSpace_IsLimited) {
  const auto is_as_given = [] {
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    return limit.rlim_cur == rlim_t{1234} << 20U ? 1 : 0;
  };
  EXPECT_EQ(Copy(is_as_given, {10, 1234}).code, 1);
}

}  // namespace
}  // namespace latchwork::process
