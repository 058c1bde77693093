// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/counted_allocations.h"
#include "tests/reasoners/pttp/avoid_theory.h"

namespace latchwork::pttp {
namespace {

TEST(AllocationTest, DecisionsAllocateNothingAfterWarmUp) {
  AgentMind mind(kAvoidTheory);
  LoadAvoid(mind);
  for (int tick = 0; tick < 10; ++tick) {
    SenseAvoid(mind, tick);
    mind.Decide();
  }
  for (int tick = 10; tick < 20; ++tick) {
    SenseAvoid(mind, tick);
    const std::size_t before = test::Allocations();
    mind.Decide();
    EXPECT_EQ(test::Allocations(), before) << "tick " << tick;
    EXPECT_EQ(mind.decision.status, sdk::Status::kProved) << mind.decision.message;
  }
}

}  // namespace
}  // namespace latchwork::pttp
