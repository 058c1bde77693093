// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "tests/core/plugin/samples/sample_reasoner.h"

namespace {

class NeverThere : public latchwork::samples::SampleReasoner {
 public:
  NeverThere() { throw std::runtime_error("not today"); }
};

}  // namespace

LATCHWORK_PLUGIN(NeverThere, "null_create", "1.0", "cannot be constructed")
