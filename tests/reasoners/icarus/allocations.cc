// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reasoners/icarus/allocations.h"

#include "tests/counted_allocations.h"

namespace latchwork::icarus::testing {

std::size_t Allocations() { return test::Allocations(); }

}  // namespace latchwork::icarus::testing
