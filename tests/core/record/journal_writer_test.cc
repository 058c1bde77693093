// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/record/journal_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/record/sample_run.h"

namespace latchwork::record::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(JournalWriterTest, SameSeedGivesTheSameBytes) {
  const std::string journal = JournalOf({.ticks = 50});
  EXPECT_EQ(journal, JournalOf({.ticks = 50}));
  EXPECT_EQ(journal, JournalOf({.ticks = 50, .threads = 3}));
  EXPECT_NE(journal, JournalOf({.seed = 2, .ticks = 50}));
}

TEST(JournalWriterTest, WritesHeaderTicksAndEnd) {
  const std::string journal = JournalOf({.seed = 3, .ticks = 2});
  JournalReader reader = ReaderOf(journal);
  const std::string first =
      R"j({"tick":0,"sensed":{"sonar":["echo(0, 3.0)"]},)j"
      R"j("latched":[{"layer":"avoid","latch":"sonar","facts":["echo(0, 3.0)"],"version":1}],)j"
      R"j("decisions":[{"layer":"avoid","status":"proved","conclusions":[{"port":"motion",)j"
      R"j("fact":"turn(1.5)","rests_on":[0]}],"assumptions":[{"made":"blocked"}],)j"
      R"j("inferences":7,"depth":3,"attachment_calls":1}],"commands":{"drive":["turn(1.5)"]}})j";
  EXPECT_THAT(Frames(reader), ElementsAre(first, HasSubstr(R"j({"tick":1,)j"),
                                          R"j({"end":{"outcome":"not reached","message":)j"
                                          R"j("the ticks of the run are used up","ticks":2,)j"
                                          R"j("measures":{"collisions":0}}})j"));
}

TEST(JournalWriterTest, HeaderReadsBack) {
  const Sample sample{.seed = UINT64_MAX};
  const std::string journal = JournalOf(sample);
  SampleAgent fake(sample);
  const JournalHeader written = HeaderOf(*fake.Assemble(sample.seed).agent);
  const JournalReader reader = ReaderOf(journal);
  ASSERT_TRUE(reader.header());
  EXPECT_THAT(Differences(written, *reader.header()), IsEmpty());
  EXPECT_EQ(reader.header()->agent, "sample");
  EXPECT_EQ(reader.header()->agent_file, "agents/sample.xml");
  EXPECT_EQ(reader.header()->scenario, "far.xml");
  EXPECT_EQ(reader.header()->seed, UINT64_MAX);
  EXPECT_EQ(reader.header()->tick_us, 100'000U);
  EXPECT_EQ(reader.header()->max_ticks, 99U);
  ASSERT_THAT(reader.header()->overrides, SizeIs(1));
  EXPECT_EQ(reader.header()->overrides[0].part, "avoid");
  EXPECT_EQ(reader.header()->plugins, written.plugins);
  EXPECT_THAT(reader.header()->plugins, SizeIs(3));
}

TEST(JournalWriterTest, DifferencesNameWhatAReplayDependsOn) {
  SampleAgent fake({});
  const JournalHeader then = HeaderOf(*fake.Assemble().agent);
  JournalHeader now = then;
  now.config_fingerprint = "4567";
  now.plugins[1].fingerprint = "89ab";
  now.overrides.clear();
  now.build = "other";
  EXPECT_THAT(
      Differences(then, now),
      ElementsAre(HasSubstr("agent file: journal '0123', now '4567'"),
                  HasSubstr("overrides: journal 'avoid.gain=2', now ''"),
                  HasSubstr("layer plugin layer0: journal '', now '89ab'"), HasSubstr("build")));
}

TEST(JournalWriterTest, FullDiskIsToldAndTheRunGoesOn) {
  EXPECT_THAT(WriteJournal({}, "/dev/full"), HasSubstr("cannot write the journal /dev/full: "));
}

TEST(JournalWriterTest, FolderThatIsNotThereIsTold) {
  EXPECT_THAT(WriteJournal({}, "/nowhere/run.journal"),
              HasSubstr("cannot make the journal /nowhere/run.journal: "));
}

}  // namespace
}  // namespace latchwork::record::testing
