// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_CONDITIONS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_CONDITIONS_H_

#include <cstddef>
#include <vector>

#include "reasoners/circumscription/engine/minimal_core.h"
#include "reasoners/circumscription/layered/layered_models.h"
#include "reasoners/circumscription/layered/layered_theory.h"

namespace latchwork::circumscription {

/// A goal by its layer.
struct LayerGoal {
  std::size_t layer = 0;
  Atom goal = 0;
  GoalStatus status = GoalStatus::kUnknown;
};

/// A bridge that some layered model gives up, and what of its layer stands against the bridges of
/// that model. The core is of WithBridges(theory, layer); bridges that are kept count as facts.
struct GivenUp {
  std::size_t layer = 0;
  std::size_t bridge = 0;
  Core core;
};

/// What the paper's theorems ask of a layered theory. (That preference is smooth, each model being
/// minimal or above a minimal one, holds of all finite theories.)
struct Conditions {
  std::vector<Verdict> layers_have_models;                ///< Each by itself, the lowest first.
  Verdict has_model = Verdict::kUnknown;                  ///< The layered theory.
  Verdict consistent_with_transfers = Verdict::kUnknown;  ///< All layers, every bridge kept.
  std::vector<LayerGoal> goals;   ///< Each goal that a bridge comes from, the highest layer first.
  std::vector<GivenUp> given_up;  ///< The highest layer first.
  bool bridges_known = true;      ///< Else a budget ran out, and given_up may lack some.

  /// Only definite instances are handed down.
  bool GoalsDecided() const;
};

Conditions CheckConditions(const LayeredTheory& theory, const EngineOptions& options = {});

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_CONDITIONS_H_
