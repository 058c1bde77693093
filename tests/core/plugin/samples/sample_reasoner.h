// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_CORE_PLUGIN_SAMPLES_SAMPLE_REASONER_H_
#define LATCHWORK_TESTS_CORE_PLUGIN_SAMPLES_SAMPLE_REASONER_H_

#include "tests/faults/fault_reasoner.h"

namespace latchwork::samples {

/// A reasoner whose answers do not matter.
class SampleReasoner : public faults::FaultReasoner {
 protected:
  void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) override {
    static_cast<void>(budget), static_cast<void>(decision);
  }
};

}  // namespace latchwork::samples

#endif  // LATCHWORK_TESTS_CORE_PLUGIN_SAMPLES_SAMPLE_REASONER_H_
