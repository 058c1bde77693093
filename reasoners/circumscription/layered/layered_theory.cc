// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/layered/layered_theory.h"

#include <fmt/format.h>

#include <algorithm>

namespace latchwork::circumscription {
namespace {

/// The premise that stands for `goal`, a new one where there is none.
Atom PremiseOf(Atom goal, const GroundTheory& above, BridgedTheory& bridged) {
  const auto place = std::find(bridged.goals.begin(), bridged.goals.end(), goal);
  if (place != bridged.goals.end()) {
    return bridged.premises[static_cast<std::size_t>(place - bridged.goals.begin())];
  }
  bridged.goals.push_back(goal);
  bridged.premises.push_back(bridged.theory.Add({Role::kFixed, 1, ToString(above, goal)}));
  return bridged.premises.back();
}

}  // namespace

std::string LayerName(const LayeredTheory& theory, std::size_t index) {
  const std::string& name = theory.layers[index].name;
  return name.empty() ? fmt::format("layer {}", index + 1)
                      : fmt::format("layer {} ({})", index + 1, name);
}

std::string BridgeName(const LayeredTheory& theory, std::size_t layer, const Bridge& bridge) {
  return fmt::format("{} of layer {} -> {} of layer {}",
                     ToString(theory.layers[layer + 1].theory, bridge.goal), layer + 2,
                     ToString(theory.layers[layer].theory, bridge.latch), layer + 1);
}

BridgedTheory WithBridges(const LayeredTheory& theory, std::size_t layer) {
  const TheoryLayer& source = theory.layers[layer];
  BridgedTheory bridged{source.theory, {}, {}, {}, {}, source.theory.clauses.size(), 0};
  for (AtomInfo& atom : bridged.theory.atoms) ++atom.level;
  for (const Bridge& bridge : source.bridges) {
    PremiseOf(bridge.goal, theory.layers[layer + 1].theory, bridged);
  }
  for (const Bridge& bridge : source.bridges) {
    const Atom premise = PremiseOf(bridge.goal, theory.layers[layer + 1].theory, bridged);
    const std::string name = fmt::format("ab({})", ToString(source.theory, bridge.latch));
    const Atom abnormal = bridged.theory.Add({Role::kMinimized, 1, name});
    bridged.abnormal.push_back(abnormal);
    bridged.theory.clauses.push_back({-premise, abnormal, bridge.latch});
  }
  bridged.first_fact_clause = bridged.theory.clauses.size();
  for (const Literal fact : source.facts) {
    if (source.theory.at(AtomOf(fact)).role == Role::kFixed) {
      bridged.latches.push_back(fact);
    } else {
      bridged.theory.clauses.push_back({fact});
    }
  }
  return bridged;
}

}  // namespace latchwork::circumscription
