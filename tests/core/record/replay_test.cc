// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/record/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "tests/core/record/sample_run.h"

namespace latchwork::record::testing {
namespace {

/// What differs when `now` is run against the journal; empty when nothing does.
std::string Compare(std::string_view journal, const Sample& now, std::uint64_t ticks) {
  JournalReader reader = ReaderOf(journal);
  SampleAgent fake(now);
  const ReplayResult result = Replay(reader, std::move(*fake.Assemble(now.seed).agent));
  EXPECT_EQ(result.ticks, ticks);
  return result.divergence ? ToString(*result.divergence) : "";
}

TEST(ReplayTest, SameRunIsIdentical) {
  // The journal's header asks for 99 ticks, whatever the agent's own duration.
  const std::string journal = JournalOf({.ticks = 200, .reached_at = 50});
  EXPECT_EQ(Compare(journal, {.ticks = 3, .reached_at = 50}, 51), "");
}

TEST(ReplayTest, ChangedGainIsNamedByTickLayerAndField) {
  const std::string journal = JournalOf({.gain = 0.5});
  EXPECT_EQ(Compare(journal, {.gain = 0.25}, 0),
            "tick 0, layer avoid, conclusion 1: journal turn(0.5), now turn(0.25)");
}

TEST(ReplayTest, OtherSeedIsNamedByTickAndSensor) {
  EXPECT_EQ(Compare(JournalOf({}), {.seed = 2}, 0),
            "tick 0, sensor sonar, fact 1: journal echo(0, 1.0), now echo(0, 2.0)");
}

TEST(ReplayTest, CutJournalIsComparedAsFarAsItGoes) {
  const std::string journal = JournalOf({});
  const std::vector<std::size_t> starts = LineStarts(journal);
  EXPECT_EQ(Compare(journal.substr(0, starts[3] + 9), {}, 2), "");
  EXPECT_EQ(Compare(journal.substr(0, starts[1]), {}, 0), "");
}

TEST(ReplayTest, RunThatGoesOnIsNamed) {
  EXPECT_EQ(Compare(JournalOf({.reached_at = 2}), {}, 3), "tick 3, run: journal over, now goes on");
}

TEST(ReplayTest, RunThatStopsIsNamed) {
  EXPECT_EQ(Compare(JournalOf({}), {.reached_at = 2}, 3),
            "tick 3, run: journal goes on, now reached: there");
}

TEST(ReplayTest, OtherOutcomeIsNamed) {
  // The journal ends because its ticks were used up, the run now because it got there.
  const std::string journal = JournalOf({.ticks = 3});
  EXPECT_EQ(Compare(journal, {.reached_at = 2}, 3),
            "tick 3, end outcome: journal not reached, now reached");
}

TEST(ReplayTest, TellsHowFarItIs) {
  const std::string journal = JournalOf({.ticks = 2});
  JournalReader reader = ReaderOf(journal);
  SampleAgent fake({});
  std::vector<std::uint64_t> told;
  Replay(reader, std::move(*fake.Assemble().agent), 1,
         [&](std::uint64_t ticks) { told.push_back(ticks); });
  EXPECT_THAT(told, ::testing::ElementsAre(1, 2));
}

}  // namespace
}  // namespace latchwork::record::testing
