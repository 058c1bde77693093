// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/layered/conditions.h"

#include <algorithm>

namespace latchwork::circumscription {
namespace {

Verdict LayerHasModel(const TheoryLayer& layer, const EngineOptions& options) {
  LayeredTheory alone;
  alone.layers.push_back(layer);
  alone.layers.front().bridges.clear();
  return LayeredModels(alone, options).HasModel();
}

/// What contradicts the bridge: the layer, the goals of the model, and the bridges that it keeps.
Core Objection(const LayeredTheory& theory, std::size_t layer, std::size_t bridge,
               const LayeredModels& models, const Model& model, int conflicts) {
  const BridgedTheory bridged = WithBridges(theory, layer);
  std::vector<Literal> facts = bridged.latches;
  for (std::size_t i = 0; i < bridged.goals.size(); ++i) {
    const bool holds = model.Holds(models.Joint(layer + 1, bridged.goals[i]));
    facts.push_back(holds ? bridged.premises[i] : -bridged.premises[i]);
  }
  for (std::size_t i = 0; i < bridged.abnormal.size(); ++i) {
    const bool kept = i == bridge || !model.Holds(models.Abnormal(layer, i));
    if (kept) facts.push_back(-bridged.abnormal[i]);
  }
  return MinimalCore(bridged.theory, facts, conflicts).value_or(Core());
}

void CheckBridges(const LayeredTheory& theory, std::size_t layer, const EngineOptions& options,
                  LayeredModels& models, Conditions& conditions) {
  for (std::size_t i = 0; i < theory.layers[layer].bridges.size(); ++i) {
    const Literal abnormal = models.Abnormal(layer, i);
    Model model;
    const SatResult result = models.Find({&abnormal, 1}, model);
    if (result == SatResult::kLimit) conditions.bridges_known = false;
    if (result != SatResult::kSatisfiable) continue;
    conditions.given_up.push_back(
        {layer, i, Objection(theory, layer, i, models, model, options.conflicts)});
  }
}

}  // namespace

bool Conditions::GoalsDecided() const {
  return std::all_of(goals.begin(), goals.end(), [](const LayerGoal& state) {
    return state.status == GoalStatus::kProved || state.status == GoalStatus::kRefuted;
  });
}

Conditions CheckConditions(const LayeredTheory& theory, const EngineOptions& options) {
  Conditions conditions;
  for (const TheoryLayer& layer : theory.layers) {
    conditions.layers_have_models.push_back(LayerHasModel(layer, options));
  }
  LayeredModels models(theory, options);
  conditions.has_model = models.HasModel();
  conditions.consistent_with_transfers = models.IsConsistentWithTransfers();
  if (conditions.has_model == Verdict::kNo) return conditions;
  for (std::size_t layer = theory.layers.size() - 1; layer-- > 0;) {
    for (const Atom goal : WithBridges(theory, layer).goals) {
      conditions.goals.push_back({layer + 1, goal, models.Decide(layer + 1, goal)});
    }
    CheckBridges(theory, layer, options, models, conditions);
  }
  return conditions;
}

}  // namespace latchwork::circumscription
