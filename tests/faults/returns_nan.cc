// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <string>

#include "tests/faults/fault_reasoner.h"

namespace latchwork::faults {
namespace {

/// Concludes fwd(NaN); where fwd is no goal, the first goal that has arguments, with NaN for each.
class ReturnsNan : public FaultReasoner {
 protected:
  void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) override {
    static_cast<void>(budget);
    decision.conclusions.clear();
    const std::size_t goal = FindGoal("fwd", 1).value_or(FirstWithArguments());
    if (goal == goals().size()) return;
    const logic::Atom& pattern = goals()[goal].pattern;
    const std::vector<logic::Term> arguments(
        pattern.arity(), logic::Term::Real(std::numeric_limits<double>::quiet_NaN()));
    Conclude(goal, pattern.predicate().name(), arguments, decision);
  }

 private:
  std::size_t FirstWithArguments() const {
    const auto found = std::find_if(goals().begin(), goals().end(),
                                    [](const sdk::Goal& goal) { return goal.pattern.arity() > 0; });
    return static_cast<std::size_t>(found - goals().begin());
  }
};

}  // namespace
}  // namespace latchwork::faults

LATCHWORK_PLUGIN(latchwork::faults::ReturnsNan, "returns_nan", "1.0", "concludes NaN")
