// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/brooks/brooks_reasoner.h"

#include <algorithm>
#include <string>
#include <utility>

#include "latchwork/sdk/specs.h"

namespace latchwork::brooks {
namespace {

bool Concludes(const sdk::Body& body, std::string_view predicate) {
  return std::any_of(body.goals.begin(), body.goals.end(), [&](const sdk::Goal& goal) {
    return goal.pattern.predicate().name() == predicate;
  });
}

logic::Diagnostics Refuse(std::string message, std::string hint) {
  return {{{}, std::move(message), std::move(hint), {}}};
}

}  // namespace

std::span<const sdk::ParameterSpec> BrooksReasoner::parameters() const {
  static const std::vector<sdk::ParameterSpec> parameters = {
      sdk::BooleanParameter("wander", false, "without anything to do it goes about, by seed"),
      sdk::IntegerParameter("whim", "50", 1, 1e6, "cycles that it keeps to a direction"),
      sdk::IntegerParameter("seed", "1", 0, 4e9, "of its whims")};
  return parameters;
}

logic::Diagnostics BrooksReasoner::Load(const sdk::Body& body, const sdk::Parameters& parameters,
                                        logic::SymbolTable& symbols) {
  const Whims whims{
      sdk::RandomStream(static_cast<std::uint64_t>(parameters.Integer("seed")), "whims"),
      parameters.Boolean("wander"), static_cast<std::uint64_t>(parameters.Integer("whim"))};
  if (Concludes(body, "fwd")) {
    behaviour_ = MakeAvoid(body, whims, symbols);
  } else if (Concludes(body, "direction")) {
    behaviour_ = MakeExplore(body, whims, symbols);
  } else {
    return Refuse("there is no behaviour for this layer",
                  "there is one for layers that conclude fwd, and one for direction");
  }
  goals_ = body.goals;
  return {};
}

void BrooksReasoner::Decide(std::span<const sdk::Latch> latches, const sdk::Budget& /*budget*/,
                            sdk::Decision& decision) {
  acts_.clear();
  behaviour_->Act(latches, acts_);
  decision.Clear();
  for (std::size_t goal = 0; goal < goals_.size(); ++goal) {
    for (const logic::Fact& act : acts_) {
      if (logic::NameOf(act) != logic::NameOf(goals_[goal].pattern)) continue;
      decision.conclusions.push_back({goal, act, {}});
    }
  }
  decision.status = decision.conclusions.empty() ? sdk::Status::kRefuted : sdk::Status::kProved;
}

void BrooksReasoner::Admit(std::span<const sdk::Latch> /*latches*/, std::size_t /*port*/,
                           std::span<const logic::Fact> /*batch*/, const sdk::Budget& /*budget*/,
                           std::vector<sdk::Refusal>& /*refused*/) {}

logic::Diagnostics BrooksReasoner::Tell(std::string_view /*text*/) {
  return Refuse("behaviours read no text", "their parameters are set in the agent file");
}

logic::Diagnostics BrooksReasoner::Retract(std::string_view /*name*/) {
  return Refuse("behaviours have nothing to retract", "their parameters are set in the agent file");
}

sdk::Derivation BrooksReasoner::Explain(std::size_t /*conclusion*/) { return {}; }

}  // namespace latchwork::brooks
