// SPDX-License-Identifier: BSD-3-Clause
#include "tests/faults/fault_reasoner.h"

namespace latchwork::faults {
namespace {

/// Finds body and latches contradictory.
class Inconsistent : public FaultReasoner {
 protected:
  void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) override {
    static_cast<void>(budget);
    decision.conclusions.clear();
    decision.status = sdk::Status::kInconsistent;
    decision.message = "inconsistent on purpose";
  }
};

}  // namespace
}  // namespace latchwork::faults

LATCHWORK_PLUGIN(latchwork::faults::Inconsistent, "inconsistent", "1.0",
                 "finds every latch contradictory")
