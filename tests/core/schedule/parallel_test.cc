// SPDX-License-Identifier: BSD-3-Clause
// However many threads decide, the run is the same.

#include <gtest/gtest.h>

#include <atomic>

#include "core/schedule/fork_join.h"
#include "latchwork/sdk/random.h"
#include "tests/core/schedule/fakes.h"

namespace latchwork::schedule::testing {
namespace {

using logic::Term;
using sdk::ArgumentType;

/// Eight layers in a chain that pass numbers down, with faults and refusals sprinkled in.
void Build(FakeAgent& fake) {
  constexpr std::size_t kLayers = 8;
  const auto number = [](const char* name) {
    return std::pair(std::string(name), std::vector{ArgumentType::kInteger});
  };
  fake.world->shape.outputs = {Port("now", {number("n")})};
  fake.world->observe = [&fake](std::uint64_t tick, std::span<sdk::Batch> sensors) {
    sensors[0].updated = true;
    sensors[0].facts = {fake.Fact("n", {Term::Integer(static_cast<std::int64_t>(tick))})};
  };
  for (std::size_t i = 0; i < kLayers; ++i) {
    fake.AddLayer({Port("sense", {number("n")}), Port("above", {number("n")})},
                  {Port("out", {number("n")})});
    fake.description(i).period = 1 + i % 3;
    fake.description(i).latency = i % 2;
    fake.Wire({kWorld, 0}, {i, 0});
    if (i > 0) fake.Wire({i, 0}, {i - 1, 1}, 4);
    fake.reasoner(i).decide = [&fake, i](std::span<const sdk::Latch> latches, auto&,
                                         sdk::Decision& decision) {
      std::int64_t sum = static_cast<std::int64_t>(i);
      for (const sdk::Latch& latch : latches) {
        for (const logic::Fact& fact : latch.facts) sum += fact.argument(0).integer();
      }
      decision.statistics.inferences = static_cast<std::uint64_t>(sum % 7);
      if (sum % 11 == 5) throw std::runtime_error("unlucky number");
      // Names made while others make theirs must not show in the result.
      fake.symbols.Intern("s" + std::to_string(sum));
      fake.Conclude(decision, 0, fake.Fact("n", {Term::Integer(sum % 1000)}));
    };
    fake.reasoner(i).admit = [](auto, std::size_t, std::span<const logic::Fact> batch,
                                std::vector<sdk::Refusal>& refused) {
      if (batch[0].argument(0).integer() % 13 == 4) refused.push_back({0, "thirteen"});
    };
  }
  fake.agent.max_ticks = 200;
}

std::vector<std::string> Transcript(unsigned threads) {
  FakeAgent fake;
  Build(fake);
  Recorder recorder;
  fake.Start({.threads = threads, .observers = {&recorder}})->Run();
  std::vector<std::string> lines = recorder.latched;
  lines.insert(lines.end(), recorder.refused.begin(), recorder.refused.end());
  lines.insert(lines.end(), recorder.decided.begin(), recorder.decided.end());
  for (const Fault& fault : recorder.faults) {
    lines.push_back(std::to_string(fault.tick) + " " + fault.plugin + " " + fault.message);
  }
  return lines;
}

TEST(ParallelTest, RunDoesNotDependOnTheThreads) {
  const auto serial = Transcript(1);
  EXPECT_GT(serial.size(), 1000U);
  EXPECT_EQ(serial, Transcript(2));
  EXPECT_EQ(serial, Transcript(4));
}

TEST(ForkJoinTest, DoesEveryJobOnce) {
  for (const unsigned threads : {0U, 1U, 2U, 4U}) {
    ForkJoin pool(threads);
    for (const std::size_t count : {0U, 1U, 2U, 100U}) {
      std::vector<std::atomic<int>> done(count);
      pool.Run(count, [&](std::size_t i) { ++done[i]; });
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(done[i], 1) << threads << " " << i;
    }
  }
}

}  // namespace
}  // namespace latchwork::schedule::testing
