// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CORE_PROCESS_LIMITS_H_
#define LATCHWORK_CORE_PROCESS_LIMITS_H_

#include <cstdint>

namespace latchwork::process {

/// As much as there is.
inline constexpr std::uint64_t kAnyMemory = ~std::uint64_t{0} >> 20U;

/// What a program may use before it is ended.
struct Limits {
  double wall_seconds = 300;
  std::uint64_t memory_mb = 4096;  ///< Address space.
};

}  // namespace latchwork::process

#endif  // LATCHWORK_CORE_PROCESS_LIMITS_H_
