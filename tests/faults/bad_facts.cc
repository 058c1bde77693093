// SPDX-License-Identifier: BSD-3-Clause
#include "tests/faults/fault_reasoner.h"

namespace latchwork::faults {
namespace {

/// Concludes what no contract allows, for its first goal.
class BadFacts : public FaultReasoner {
 public:
  BadFacts()
      : FaultReasoner(
            {{"fact",
              sdk::ParameterType::kText,
              "undeclared",
              0,
              0,
              "",
              "undeclared: a predicate outside the contract; type: words for numbers; open: a "
              "variable; goal: for a goal that there is not; assumption: rests on one that there "
              "is not",
              {"undeclared", "type", "open", "goal", "assumption"}}}) {}

 protected:
  void Configure(const sdk::Parameters& parameters) override { fact_ = parameters.Text("fact"); }

  void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) override {
    static_cast<void>(budget);
    decision.conclusions.clear();
    const std::size_t goal = FindGoal("fwd", 1).value_or(0);
    if (fact_ == "undeclared") {
      Conclude(goal, "not_in_the_contract", logic::Term::Integer(1), decision);
    } else if (fact_ == "type") {
      Conclude(goal, "fwd", logic::Term::Constant(symbols().Intern("fast")), decision);
    } else if (fact_ == "open") {
      Conclude(goal, "fwd", logic::Term::Var(0), decision);
    } else if (fact_ == "goal") {
      Conclude(goals().size(), "fwd", logic::Term::Real(0.1), decision);
    } else {
      Conclude(goal, "fwd", logic::Term::Real(0.1), decision);
      decision.conclusions.back().assumptions.push_back(decision.assumptions.size());
    }
  }

 private:
  std::string fact_;
};

}  // namespace
}  // namespace latchwork::faults

LATCHWORK_PLUGIN(latchwork::faults::BadFacts, "bad_facts", "1.0", "concludes outside its contract")
