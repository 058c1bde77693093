// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/record/journal_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/logic/fingerprint.h"
#include "core/record/frame.h"
#include "tests/core/record/sample_run.h"

namespace latchwork::record::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string Framed(std::string_view json) {
  std::string frame;
  AppendFrame(json, logic::Fingerprint(json), frame);
  return frame;
}

std::string HeaderLine() {
  const std::string journal = JournalOf({});
  return journal.substr(0, journal.find('\n') + 1);
}

std::string ProblemOf(std::string_view bytes) {
  JournalReader reader = ReaderOf(bytes);
  Frames(reader);
  return reader.problem() ? reader.problem()->message : "";
}

TEST(JournalReaderTest, GivesEveryFrame) {
  JournalReader reader = ReaderOf(JournalOf({.ticks = 30}));
  EXPECT_THAT(Frames(reader), SizeIs(31));
  EXPECT_FALSE(reader.tail_cut());
  EXPECT_FALSE(reader.problem());
  EXPECT_FALSE(reader.Next());
}

TEST(JournalReaderTest, CutAtEveryByteGivesAllWholeFrames) {
  const std::string journal = JournalOf({});
  const std::string_view text = journal;
  const std::vector<std::size_t> starts = LineStarts(journal);
  for (std::size_t length = 0; length < journal.size(); ++length) {
    JournalReader reader = ReaderOf(text.substr(0, length));
    const auto whole = std::upper_bound(starts.begin(), starts.end(), length) - starts.begin() - 1;
    ASSERT_EQ(reader.header().has_value(), whole > 0) << length;
    ASSERT_EQ(reader.problem().has_value(), whole == 0) << length;
    if (whole > 0) {
      ASSERT_THAT(Frames(reader), SizeIs(whole - 1)) << length;
    }
    ASSERT_TRUE(reader.tail_cut()) << length;
  }
}

/// A byte of a length may be written in another case; everything else is noticed.
TEST(JournalReaderTest, EveryChangedByteIsNoticed) {
  const std::string journal = JournalOf({.ticks = 2});
  JournalReader intact = ReaderOf(journal);
  const std::vector<std::string> frames = Frames(intact);
  for (std::size_t i = 0; i < journal.size(); ++i) {
    for (const int change : {1, 32, 128}) {
      std::string damaged = journal;
      damaged[i] = static_cast<char>(damaged[i] ^ change);
      JournalReader reader = ReaderOf(damaged);
      const bool same = Frames(reader) == frames;
      ASSERT_TRUE(reader.problem() || reader.tail_cut() || (same && change == 32)) << i;
    }
  }
}

TEST(JournalReaderTest, DamageIsReportedWithItsPlace) {
  std::string journal = JournalOf({});
  const std::size_t third = LineStarts(journal)[2];
  journal[third + 40] ^= 1;
  JournalReader reader = ReaderOf(journal);
  EXPECT_THAT(Frames(reader), SizeIs(1));
  ASSERT_TRUE(reader.problem());
  EXPECT_EQ(reader.problem()->place.file, "run.journal");
  EXPECT_EQ(reader.problem()->place.line, 3U);
  EXPECT_THAT(reader.problem()->message, HasSubstr("at byte " + std::to_string(third)));
  EXPECT_THAT(reader.problem()->message, HasSubstr("does not match its checksum"));
}

TEST(JournalReaderTest, LostAndExchangedFramesAreNoticed) {
  const std::string journal = JournalOf({});
  const std::vector<std::size_t> starts = LineStarts(journal);
  const auto line = [&](std::size_t i) {
    return journal.substr(starts[i], starts[i + 1] - starts[i]);
  };
  EXPECT_THAT(ProblemOf(line(0) + line(2) + line(3)), HasSubstr("does not match its checksum"));
  EXPECT_THAT(ProblemOf(line(0) + line(1) + line(3) + line(2)), HasSubstr("does not match"));
  EXPECT_THAT(ProblemOf(line(0) + line(1) + line(1)), HasSubstr("does not match"));
}

TEST(JournalReaderTest, HashesAreChained) {
  JournalReader a = ReaderOf(JournalOf({.ticks = 3}));
  JournalReader b = ReaderOf(JournalOf({.ticks = 3, .reached_at = 2}));
  JournalReader other = ReaderOf(JournalOf({.gain = 0.25, .ticks = 3}));
  for (int tick = 0; tick < 3; ++tick) {
    const std::uint64_t hash = a.Next()->hash;
    EXPECT_EQ(hash, b.Next()->hash) << tick;
    EXPECT_NE(hash, other.Next()->hash) << tick;
  }
  EXPECT_NE(a.Next()->hash, b.Next()->hash);
}

TEST(JournalReaderTest, NewerVersionIsNamed) {
  const std::string problem = ProblemOf(Framed(R"j({"format":"latchwork journal","version":2})j"));
  EXPECT_THAT(problem, HasSubstr("version 2"));
  EXPECT_THAT(problem, HasSubstr("up to version 1"));
}

TEST(JournalReaderTest, WhatIsNoJournalIsRefused) {
  EXPECT_THAT(ProblemOf(""), HasSubstr("not a journal"));
  EXPECT_THAT(ProblemOf(std::string(1000, 'x')), HasSubstr("not a journal"));
  EXPECT_THAT(ProblemOf(std::string(1000, '\0')), HasSubstr("not a journal"));
  EXPECT_THAT(ProblemOf(Framed("[]")), HasSubstr("header cannot be read"));
  EXPECT_THAT(ProblemOf(Framed(R"j({"format":"other"})j")), HasSubstr("not a journal"));
  EXPECT_THAT(ProblemOf(Framed(R"j({"format":"latchwork journal","version":1})j")),
              HasSubstr("header cannot be read"));
  EXPECT_THAT(ProblemOf(Framed(R"j({"format":"latchwork journal","version":-1})j")),
              HasSubstr("header cannot be read"));
}

TEST(JournalReaderTest, FileThatCannotBeOpenedIsTold) {
  for (const char* file : {"/nowhere/run.journal", "/tmp", ""}) {
    JournalReader reader{std::filesystem::path(file)};
    EXPECT_FALSE(reader.header());
    ASSERT_TRUE(reader.problem()) << file;
    EXPECT_EQ(reader.problem()->message, "the journal cannot be opened");
    EXPECT_FALSE(reader.Next());
  }
}

TEST(JournalReaderTest, ForgedFramesAreRefused) {
  const std::string header = HeaderLine();
  EXPECT_THAT(ProblemOf(header + "ffffffff 0000000000000000 {"), HasSubstr("no frame begins"));
  EXPECT_THAT(ProblemOf(header + Framed("{\"tick\":")), HasSubstr("no JSON"));
  EXPECT_THAT(ProblemOf(header + Framed(R"j({"tick":7})j")), HasSubstr("not that of tick 0"));
  EXPECT_THAT(ProblemOf(header + Framed("{}")), HasSubstr("not that of tick 0"));
  const std::string deep =
      "{\"tick\":0,\"x\":" + std::string(100'000, '[') + std::string(100'000, ']') + "}";
  EXPECT_THAT(ProblemOf(header + Framed(deep)), HasSubstr("no JSON"));
  EXPECT_THAT(ProblemOf(header + Framed(R"j({"end":{}})j") + "x"), HasSubstr("more follows"));
}

}  // namespace
}  // namespace latchwork::record::testing
