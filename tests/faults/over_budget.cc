// SPDX-License-Identifier: BSD-3-Clause
#include "tests/faults/fault_reasoner.h"

namespace latchwork::faults {
namespace {

/// Says that it used more inferences than it was given.
class OverBudget : public FaultReasoner {
 public:
  OverBudget()
      : FaultReasoner({{"excess",
                        sdk::ParameterType::kInteger,
                        "1",
                        1,
                        1e9,
                        "",
                        "inferences used beyond the budget",
                        {}}}) {}

 protected:
  void Configure(const sdk::Parameters& parameters) override {
    excess_ = static_cast<std::uint64_t>(parameters.Integer("excess"));
  }
  void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) override {
    decision.statistics.inferences = budget.inferences + excess_;
  }

 private:
  std::uint64_t excess_ = 0;
};

}  // namespace
}  // namespace latchwork::faults

LATCHWORK_PLUGIN(latchwork::faults::OverBudget, "over_budget", "1.0",
                 "uses more inferences than its budget has")
