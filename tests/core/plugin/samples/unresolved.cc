// SPDX-License-Identifier: BSD-3-Clause
#include "tests/core/plugin/samples/sample_reasoner.h"

extern "C" int latchwork_defined_nowhere();

namespace {

class Unresolved : public latchwork::samples::SampleReasoner {
 public:
  std::string_view language() const override {
    return latchwork_defined_nowhere() == 0 ? "" : "none";
  }
};

}  // namespace

LATCHWORK_PLUGIN(Unresolved, "unresolved", "1.0", "calls a function that is defined nowhere")
