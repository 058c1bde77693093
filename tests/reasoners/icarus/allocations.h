// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_ICARUS_ALLOCATIONS_H_
#define LATCHWORK_TESTS_REASONERS_ICARUS_ALLOCATIONS_H_

#include <cstddef>

namespace latchwork::icarus::testing {

/// Calls of operator new since the test program began.
std::size_t Allocations();

}  // namespace latchwork::icarus::testing

#endif  // LATCHWORK_TESTS_REASONERS_ICARUS_ALLOCATIONS_H_
