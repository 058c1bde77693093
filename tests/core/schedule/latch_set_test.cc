// SPDX-License-Identifier: BSD-3-Clause
#include "core/schedule/latch_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/schedule/fakes.h"

namespace latchwork::schedule::testing {
namespace {

using logic::Fact;
using logic::Term;
using sdk::ArgumentType;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Port 0 `sonar` and 1 `robot` are sensors; 2 `objects` and 3 `orders` come from higher layers.
class LatchSetTest : public ::testing::Test {
 protected:
  LatchSetTest()
      : latches({{Port("sonar", {{"echo", {ArgumentType::kReal}}}), true, std::nullopt},
                 {Port("robot", {{"radius", {ArgumentType::kReal}}}), true, std::nullopt},
                 {Port("objects", {{"object", {ArgumentType::kSymbol}}}), false, 3},
                 {Port("orders", {{"order", {ArgumentType::kSymbol}}}), false, std::nullopt}},
                symbols) {}

  Fact Echo(double distance) { return {symbols.Intern("echo"), {Term::Real(distance)}}; }
  Fact Radius(double radius) { return {symbols.Intern("radius"), {Term::Real(radius)}}; }
  Fact Of(std::string_view predicate, std::string_view name) {
    return {symbols.Intern(predicate), {Term::Constant(symbols.Intern(name))}};
  }

  void Offer(std::size_t port, std::vector<Fact> batch, std::uint64_t tick) {
    latches.Offer(port, {true, std::move(batch), {}}, tick);
  }
  void Settle(std::uint64_t tick) { latches.Settle(tick, reasoner, {}, settlement); }
  std::string Held(std::size_t port) const { return Join(latches.latches()[port].facts); }
  std::uint64_t Version(std::size_t port) const { return latches.latches()[port].version; }
  std::vector<std::string> Refused() const {
    std::vector<std::string> lines;
    for (const auto& each : settlement.refused) {
      lines.push_back(logic::ToString(each.fact) + ": " + each.reason);
    }
    return lines;
  }

  /// Refuses fact `what` while any of the latches shown holds `because`.
  void RefuseWhile(Fact what, Fact because) {
    reasoner.admit = [what, because](std::span<const sdk::Latch> shown, std::size_t,
                                     std::span<const Fact> batch,
                                     std::vector<sdk::Refusal>& refused) {
      const bool held = std::any_of(shown.begin(), shown.end(), [&](const sdk::Latch& latch) {
        return std::find(latch.facts.begin(), latch.facts.end(), because) != latch.facts.end();
      });
      for (std::size_t i = 0; held && i < batch.size(); ++i) {
        if (batch[i] == what) refused.push_back({i, "contradicts"});
      }
    };
  }

  logic::SymbolTable symbols;
  FakeReasoner reasoner;
  LatchSet latches;
  Settlement settlement;
};

TEST_F(LatchSetTest, BatchReplacesTheOneBefore) {
  Offer(0, {Echo(1), Echo(2)}, 0);
  Settle(0);
  EXPECT_EQ(Held(0), "echo(1.0) echo(2.0)");
  Offer(0, {Echo(3)}, 1);
  Settle(1);
  EXPECT_EQ(Held(0), "echo(3.0)");
  Offer(0, {}, 2);
  Settle(2);
  EXPECT_EQ(Held(0), "");
  EXPECT_EQ(Version(0), 3U);
}

TEST_F(LatchSetTest, LastOfSeveralBatchesBeforeACycleCounts) {
  Offer(0, {Echo(1)}, 0);
  Offer(0, {Echo(2)}, 1);
  Settle(1);
  EXPECT_EQ(Held(0), "echo(2.0)");
  EXPECT_EQ(Version(0), 1U);
}

TEST_F(LatchSetTest, VersionChangesOnlyWithTheContent) {
  Offer(0, {Echo(1)}, 0);
  Settle(0);
  EXPECT_EQ(settlement.changes.size(), 1U);
  Offer(0, {Echo(1)}, 1);
  Settle(1);
  EXPECT_THAT(settlement.changes, IsEmpty());
  Settle(2);
  EXPECT_EQ(Version(0), 1U);
  EXPECT_EQ(Held(0), "echo(1.0)");
}

/// The prover, for one, keeps what a latch of the same version held.
TEST_F(LatchSetTest, HiddenLatch_HasAnotherVersionThanItsContent) {
  Offer(0, {Echo(1)}, 0);
  Offer(1, {Radius(1)}, 0);
  Offer(2, {Of("object", "o")}, 0);
  Settle(0);
  std::vector<std::uint64_t> versions;
  reasoner.admit = [&](std::span<const sdk::Latch> shown, std::size_t port, auto, auto&) {
    if (port != 0) return;
    for (const sdk::Latch& latch : shown) versions.push_back(latch.version);
  };
  Offer(0, {Echo(2)}, 1);
  Offer(1, {Radius(2)}, 1);
  Settle(1);
  ASSERT_EQ(versions.size(), 4U);
  EXPECT_GT(versions[1], 2U);
  EXPECT_GT(versions[2], 2U);
  EXPECT_EQ(Version(1), 2U);
  EXPECT_EQ(Version(2), 1U);
  EXPECT_EQ(Held(2), "object(o)");
}

TEST_F(LatchSetTest, UndeclaredPredicatesStayBehindSilently) {
  Offer(0, {Echo(1), Radius(2)}, 0);
  Settle(0);
  EXPECT_EQ(Held(0), "echo(1.0)");
  EXPECT_THAT(Refused(), IsEmpty());
}

TEST_F(LatchSetTest, FactsThatBreakTheContractAreRefusedOneByOne) {
  Offer(0, {Echo(std::nan("")), Echo(1), Fact(symbols.Intern("echo"), {Term::Var(0)})}, 0);
  Settle(0);
  EXPECT_EQ(Held(0), "echo(1.0)");
  EXPECT_EQ(settlement.refused.size(), 2U);
  EXPECT_EQ(settlement.refused[0].reason, "argument 1 of echo/1 must be a finite number");
}

TEST_F(LatchSetTest, StaleLatchIsEmptiedAndFilledAgain) {
  Offer(2, {Of("object", "o")}, 1);
  Settle(1);
  Settle(3);
  EXPECT_EQ(Held(2), "object(o)");
  Settle(4);
  EXPECT_EQ(Held(2), "");
  ASSERT_EQ(settlement.changes.size(), 1U);
  EXPECT_TRUE(settlement.changes[0].stale);
  Settle(5);
  EXPECT_THAT(settlement.changes, IsEmpty());
  Offer(2, {Of("object", "o")}, 6);
  Settle(6);
  EXPECT_EQ(Held(2), "object(o)");
}

TEST_F(LatchSetTest, RenewedBatchDoesNotGoStale) {
  for (std::uint64_t tick = 0; tick < 9; ++tick) {
    if (tick % 3 == 0) Offer(2, {Of("object", "o")}, tick);
    Settle(tick);
    EXPECT_EQ(Held(2), "object(o)") << tick;
  }
  EXPECT_EQ(Version(2), 1U);
}

TEST_F(LatchSetTest, BatchThatIsStaleBeforeTheCycleNeverShows) {
  Offer(2, {Of("object", "o")}, 1);
  Settle(9);
  EXPECT_EQ(Held(2), "");
  EXPECT_EQ(Version(2), 0U);
}

TEST_F(LatchSetTest, ContradictingFactOfAHigherLayerIsRefusedAloneAndComesBack) {
  RefuseWhile(Of("object", "ghost"), Echo(1));
  Offer(0, {Echo(1)}, 0);
  Offer(2, {Of("object", "o"), Of("object", "ghost")}, 0);
  Settle(0);
  EXPECT_EQ(Held(2), "object(o)");
  EXPECT_THAT(Refused(), ElementsAre("object(ghost): contradicts"));
  Settle(1);
  EXPECT_THAT(Refused(), IsEmpty()) << "told once, not in every cycle";
  Offer(0, {Echo(2)}, 2);
  Settle(2);
  EXPECT_EQ(Held(2), "object(o) object(ghost)");
}

TEST_F(LatchSetTest, NewSensorFactExpelsWhatAHigherLayerSaid) {
  RefuseWhile(Of("object", "ghost"), Echo(1));
  Offer(2, {Of("object", "ghost")}, 0);
  Settle(0);
  EXPECT_EQ(Held(2), "object(ghost)");
  Offer(0, {Echo(1)}, 1);
  Settle(1);
  EXPECT_EQ(Held(0), "echo(1.0)");
  EXPECT_EQ(Held(2), "");
  EXPECT_THAT(Refused(), ElementsAre("object(ghost): contradicts"));
}

TEST_F(LatchSetTest, SensorFactIsNotRefusedForWhatAHigherLayerSaid) {
  RefuseWhile(Echo(1), Of("object", "ghost"));
  Offer(2, {Of("object", "ghost")}, 0);
  Settle(0);
  Offer(0, {Echo(1)}, 1);
  Settle(1);
  EXPECT_EQ(Held(0), "echo(1.0)");
  EXPECT_THAT(Refused(), IsEmpty());
}

TEST_F(LatchSetTest, LaterInputYieldsToTheEarlierOne) {
  RefuseWhile(Of("order", "x"), Of("object", "o"));
  Offer(3, {Of("order", "x")}, 0);
  Settle(0);
  EXPECT_EQ(Held(3), "order(x)");
  Offer(2, {Of("object", "o")}, 1);
  Settle(1);
  EXPECT_EQ(Held(2), "object(o)");
  EXPECT_EQ(Held(3), "");
}

TEST_F(LatchSetTest, OldContentOfAPortDoesNotSpeakAgainstItsNewBatch) {
  RefuseWhile(Echo(2), Echo(1));
  Offer(0, {Echo(1)}, 0);
  Settle(0);
  Offer(0, {Echo(2)}, 1);
  Settle(1);
  EXPECT_EQ(Held(0), "echo(2.0)");
}

TEST_F(LatchSetTest, SensorsThatChangeTogetherAreNotHeldAgainstTheirPast) {
  RefuseWhile(Echo(2), Radius(1));
  Offer(0, {Echo(1)}, 0);
  Offer(1, {Radius(1)}, 0);
  Settle(0);
  Offer(0, {Echo(2)}, 1);
  Offer(1, {Radius(2)}, 1);
  Settle(1);
  EXPECT_EQ(Held(0), "echo(2.0)");
  EXPECT_EQ(Held(1), "radius(2.0)");
}

TEST_F(LatchSetTest, SameBatchAmongSameLatchesIsNotCheckedAgain) {
  Offer(0, {Echo(1)}, 0);
  Offer(2, {Of("object", "o")}, 0);
  Settle(0);
  EXPECT_EQ(reasoner.admit_calls, 2U);
  Offer(0, {Echo(1)}, 1);
  Offer(2, {Of("object", "o")}, 1);
  Settle(1);
  EXPECT_EQ(reasoner.admit_calls, 2U);
}

TEST_F(LatchSetTest, RefusalsOutOfRangeAreIgnored) {
  reasoner.admit = [](auto, std::size_t, auto, std::vector<sdk::Refusal>& refused) {
    refused.push_back({99, "no such fact"});
  };
  Offer(0, {Echo(1)}, 0);
  Settle(0);
  EXPECT_EQ(Held(0), "echo(1.0)");
  EXPECT_THAT(Refused(), IsEmpty());
}

TEST_F(LatchSetTest, CheckThatThrowsKeepsTheBatchOutAndIsTriedAgain) {
  reasoner.admit = [](auto, std::size_t, auto, auto&) { throw std::runtime_error("boom"); };
  Offer(0, {Echo(1)}, 0);
  Settle(0);
  EXPECT_THAT(settlement.problems, ElementsAre("boom"));
  EXPECT_EQ(Held(0), "");
  Settle(1);
  EXPECT_THAT(settlement.problems, ElementsAre("boom"));
  reasoner.admit = nullptr;
  Settle(2);
  EXPECT_THAT(settlement.problems, IsEmpty());
  EXPECT_EQ(Held(0), "echo(1.0)");
}

}  // namespace
}  // namespace latchwork::schedule::testing
