// SPDX-License-Identifier: BSD-3-Clause
// Counts the calls of operator new in this test program.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "tests/reasoners/pttp/avoid_theory.h"

namespace {

std::size_t& Allocations() {
  static std::size_t count = 0;
  return count;
}

}  // namespace

void* operator new(std::size_t size) {
  ++Allocations();
  if (void* memory = std::malloc(size); memory != nullptr) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++Allocations();
  return std::malloc(size);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

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
    const std::size_t before = Allocations();
    mind.Decide();
    EXPECT_EQ(Allocations(), before) << "tick " << tick;
    EXPECT_EQ(mind.decision.status, sdk::Status::kProved) << mind.decision.message;
  }
}

}  // namespace
}  // namespace latchwork::pttp
