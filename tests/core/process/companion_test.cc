// SPDX-License-Identifier: BSD-3-Clause
#include "core/process/companion.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

namespace latchwork::process {
namespace {

using Reply = Companion::Reply;

struct Speaker {
  explicit Speaker(const std::string& script) {
    EXPECT_TRUE(companion.Start("/bin/sh", {"-c", script}, 4096));
  }
  Reply Read() { return companion.ReadLine(line, {}); }

  Companion companion;
  std::string line;
};

TEST(CompanionTest, LinesGoBothWays) {
  Speaker cat("exec cat");
  ASSERT_TRUE(cat.companion.Send("one\ntwo\nthr", {}));
  EXPECT_EQ(cat.Read(), Reply::kLine);
  EXPECT_EQ(cat.line, "one");
  EXPECT_EQ(cat.Read(), Reply::kLine);
  EXPECT_EQ(cat.line, "two");
  ASSERT_TRUE(cat.companion.Send("ee\n", {}));
  EXPECT_EQ(cat.Read(), Reply::kLine);
  EXPECT_EQ(cat.line, "three");
}

TEST(CompanionTest, MoreThanPipesHold_IsHeardWhileItIsTold) {
  Speaker cat("exec cat");
  const std::string text(2'000'000, 'x');
  ASSERT_TRUE(cat.companion.Send(text + "\n", {}));
  EXPECT_EQ(cat.Read(), Reply::kLine);
  EXPECT_EQ(cat.line, text);
}

TEST(CompanionTest, End_IsNoticed) {
  Speaker brief("echo last; echo why >&2");
  EXPECT_EQ(brief.Read(), Reply::kLine);
  EXPECT_EQ(brief.Read(), Reply::kEnded);
  EXPECT_FALSE(brief.companion.is_running());
  EXPECT_FALSE(brief.companion.Send("more\n", {}));
}

TEST(CompanionTest, Deadline_LeavesItAlive) {
  Speaker cat("exec cat");
  EXPECT_EQ(cat.companion.ReadLine(cat.line, {Companion::Clock::now(), nullptr}), Reply::kLate);
  ASSERT_TRUE(cat.companion.Send("still here\n", {}));
  EXPECT_EQ(cat.Read(), Reply::kLine);
  EXPECT_EQ(cat.line, "still here");
}

TEST(CompanionTest, Cancellation_IsHeard) {
  Speaker cat("exec cat");
  const std::atomic<bool> cancelled = true;
  EXPECT_EQ(cat.companion.ReadLine(cat.line, {std::nullopt, &cancelled}), Reply::kCancelled);
}

TEST(CompanionTest, Kill_EndsOneThatDoesNotListen) {
  Speaker deaf("cat /dev/zero >/dev/null & wait");
  deaf.companion.Kill();
  EXPECT_FALSE(deaf.companion.is_running());
}

TEST(FindProgramTest, LooksInThePath) {
  EXPECT_TRUE(FindProgram("sh").is_absolute());
  EXPECT_TRUE(FindProgram("no-such-program-anywhere").empty());
}

}  // namespace
}  // namespace latchwork::process
