// SPDX-License-Identifier: BSD-3-Clause
#include "tests/faults/fault_reasoner.h"

namespace latchwork::faults {
namespace {

/// Says 'no' to every goal.
class Silent : public FaultReasoner {
 protected:
  void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) override {
    static_cast<void>(budget);
    decision.conclusions.clear();
    decision.status = sdk::Status::kRefuted;
  }
};

}  // namespace
}  // namespace latchwork::faults

LATCHWORK_PLUGIN(latchwork::faults::Silent, "silent", "1.0", "concludes nothing")
