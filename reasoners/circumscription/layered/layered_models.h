// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_LAYERED_MODELS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_LAYERED_MODELS_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "reasoners/circumscription/engine/engine.h"
#include "reasoners/circumscription/layered/layered_theory.h"
#include "reasoners/circumscription/layered/procedure.h"
#include "reasoners/circumscription/sat/sat_solver.h"
#include "reasoners/circumscription/search/minimal_models.h"

namespace latchwork::circumscription {

/// Definition 1 itself: the models of a layered theory, found by one SAT solver over the atoms of
/// all layers. Candidates satisfy all layers; one whose part in some layer is not minimal, what
/// the others say being fixed, teaches the solver a flip formula of that layer. Does not go from
/// layer to layer, as the procedure does, so that the two can be held against each other.
class LayeredModels {
 public:
  /// Of the options, `conflicts` and `calls` count.
  explicit LayeredModels(const LayeredTheory& theory, const EngineOptions& options = {});

  /// The literal of a layer in models of all layers.
  Literal Joint(std::size_t layer, Literal literal) const;
  /// Whether the bridge is given up.
  Literal Abnormal(std::size_t layer, std::size_t bridge) const;

  /// A model in which all of `required` hold. Literals are joint ones.
  SatResult Find(std::span<const Literal> required, Model& model);

  Verdict HasModel();
  /// Whether all models satisfy the disjunction of literals of the lowest layer.
  Answer Entails(std::span<const Literal> clause);
  GoalStatus Decide(std::size_t layer, Atom goal);
  /// Whether all layers together, every bridge kept, have a classical model.
  Verdict IsConsistentWithTransfers();

 private:
  struct Part {
    std::unique_ptr<CompiledTheory> theory;  ///< Of one layer; foreign atoms are fixed.
    std::unique_ptr<MinimalModels> below;
    std::unique_ptr<Formulas> formulas;
  };

  GroundTheory JointTheory(const BridgedTheory& bridged, std::size_t layer) const;
  Model Read();
  /// Whether the model is minimal in all layers; where it is not, why is learnt.
  SatResult Check(const Model& model);

  EngineOptions options_;
  std::vector<Atom> first_;     ///< What an atom 0 of the layer would be.
  std::vector<Atom> first_ab_;  ///< The ab of the layer's bridge 0.
  int atoms_ = 0;
  std::unique_ptr<SatSolver> solver_;
  std::vector<Part> parts_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_LAYERED_MODELS_H_
