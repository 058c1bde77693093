// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <cstdlib>

#include "tests/faults/fault_reasoner.h"

namespace latchwork::faults {
namespace {

struct Abort {
  Abort() {
    std::fputs("no device\n", stderr);
    std::abort();
  }
};
const Abort kAbort;

class EndsOnLoading : public FaultReasoner {
 protected:
  void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) override {
    static_cast<void>(budget), static_cast<void>(decision);
  }
};

}  // namespace
}  // namespace latchwork::faults

LATCHWORK_PLUGIN(latchwork::faults::EndsOnLoading, "ends_on_loading", "1.0",
                 "ends the process that loads it")
