// SPDX-License-Identifier: BSD-3-Clause
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <thread>

#include "tests/faults/fault_reasoner.h"

namespace latchwork::faults {
namespace {

/// Ends the process that it is in, or the one that started that; or itself never ends.
class Ends : public FaultReasoner {
 public:
  Ends()
      : FaultReasoner({{"what",
                        sdk::ParameterType::kText,
                        "process",
                        0,
                        0,
                        "",
                        "what ends",
                        {"process", "parent", "nothing"}}}) {}

 protected:
  void Configure(const sdk::Parameters& parameters) override { what_ = parameters.Text("what"); }
  void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) override {
    static_cast<void>(budget), static_cast<void>(decision);
    if (what_ == "process") std::abort();
    if (what_ == "parent") kill(getppid(), SIGKILL);
    while (true) std::this_thread::yield();
  }

 private:
  std::string what_;
};

}  // namespace
}  // namespace latchwork::faults

LATCHWORK_PLUGIN(latchwork::faults::Ends, "ends", "1.0", "ends what it is in, or never ends")
