// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_OMPL_REASONER_H_
#define LATCHWORK_OMPL_OMPL_REASONER_H_

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "latchwork/sdk/reasoner.h"
#include "reasoners/ompl/layers/job.h"

namespace latchwork::planning {

/// Sampling-based planners over the map of a building. It reads no body: it meets the contracts of
/// `seek`, `elevators` and `itinerary`, which it knows by their outputs. What was planned stays
/// until it no longer fits, so Decide is a function of the cycles before, too.
class OmplReasoner final : public sdk::Reasoner {
 public:
  std::string_view language() const override { return ""; }
  bool keeps_memory() const override { return true; }
  std::span<const sdk::ParameterSpec> parameters() const override;

  logic::Diagnostics Load(const sdk::Body& body, const sdk::Parameters& parameters,
                          logic::SymbolTable& symbols) override;
  /// kRefuted when the map leaves no way or nothing is asked for, kUnknown when the planner found
  /// none within the budget. Inferences are states and motions checked and rounds of the planner.
  void Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
              sdk::Decision& decision) override;
  /// Refuses nothing.
  void Admit(std::span<const sdk::Latch> latches, std::size_t port,
             std::span<const logic::Fact> batch, const sdk::Budget& budget,
             std::vector<sdk::Refusal>& refused) override;
  /// There is no text to add to or to take from.
  logic::Diagnostics Tell(std::string_view text) override;
  logic::Diagnostics Retract(std::string_view name) override;
  /// Keeps no derivations.
  sdk::Derivation Explain(std::size_t conclusion) override;

 private:
  void Conclude(const Verdict& verdict, sdk::Decision& decision) const;

  std::unique_ptr<BuildingMap> map_;  ///< The job refers to it.
  std::unique_ptr<Job> job_;
  std::vector<sdk::Goal> goals_;
};

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_OMPL_REASONER_H_
