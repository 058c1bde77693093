// SPDX-License-Identifier: BSD-3-Clause
//
// Counts the calls of operator new in a test program. To be included in one of its sources only.
#ifndef LATCHWORK_TESTS_COUNTED_ALLOCATIONS_H_
#define LATCHWORK_TESTS_COUNTED_ALLOCATIONS_H_

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace latchwork::test {

inline std::atomic<std::size_t>& AllocationCounter() {
  static std::atomic<std::size_t> count = 0;
  return count;
}
/// Of all threads, since the program began.
inline std::size_t Allocations() { return AllocationCounter(); }

}  // namespace latchwork::test

// Replacements of operator new may not be inline. Where a compiler expands only one of a pair of
// calls, it would warn of a mismatch.
// NOLINTBEGIN(misc-definitions-in-headers)
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++latchwork::test::AllocationCounter();
  if (void* memory = std::malloc(size); memory != nullptr) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++latchwork::test::AllocationCounter();
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
// NOLINTEND(misc-definitions-in-headers)

#endif  // LATCHWORK_TESTS_COUNTED_ALLOCATIONS_H_
