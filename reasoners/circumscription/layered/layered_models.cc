// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/layered/layered_models.h"

#include <utility>

namespace latchwork::circumscription {
namespace {

Verdict ToVerdict(SatResult result) {
  if (result == SatResult::kLimit) return Verdict::kUnknown;
  return result == SatResult::kSatisfiable ? Verdict::kYes : Verdict::kNo;
}

}  // namespace

LayeredModels::LayeredModels(const LayeredTheory& theory, const EngineOptions& options)
    : options_(options) {
  for (const TheoryLayer& layer : theory.layers) {
    first_.push_back(atoms_);
    atoms_ += static_cast<int>(layer.theory.atoms.size());
  }
  for (const TheoryLayer& layer : theory.layers) {
    first_ab_.push_back(atoms_ + 1);
    atoms_ += static_cast<int>(layer.bridges.size());
  }
  solver_ = std::make_unique<SatSolver>(atoms_);
  for (std::size_t i = 0; i < theory.layers.size(); ++i) {
    const GroundTheory joint = JointTheory(WithBridges(theory, i), i);
    Part part{std::make_unique<CompiledTheory>(joint), nullptr, nullptr};
    for (std::size_t k = 0; k < part.theory->clause_count(); ++k) {
      solver_->Add(part.theory->clause(k));
    }
    part.below = std::make_unique<MinimalModels>(*part.theory, options.conflicts);
    part.formulas = std::make_unique<Formulas>(*part.theory, *solver_);
    parts_.push_back(std::move(part));
  }
}

Literal LayeredModels::Joint(std::size_t layer, Literal literal) const {
  return literal > 0 ? first_[layer] + literal : literal - first_[layer];
}

Literal LayeredModels::Abnormal(std::size_t layer, std::size_t bridge) const {
  return first_ab_[layer] + static_cast<Literal>(bridge);
}

/// The theory of one layer over all atoms.
GroundTheory LayeredModels::JointTheory(const BridgedTheory& bridged, std::size_t layer) const {
  std::vector<Atom> joint(bridged.theory.atoms.size() + 1, 0);
  for (std::size_t i = 1; i < joint.size(); ++i) joint[i] = Joint(layer, static_cast<Atom>(i));
  for (std::size_t i = 0; i < bridged.premises.size(); ++i) {
    joint[static_cast<std::size_t>(bridged.premises[i])] = Joint(layer + 1, bridged.goals[i]);
  }
  for (std::size_t i = 0; i < bridged.abnormal.size(); ++i) {
    joint[static_cast<std::size_t>(bridged.abnormal[i])] = Abnormal(layer, i);
  }
  GroundTheory theory;
  theory.atoms.resize(static_cast<std::size_t>(atoms_), {Role::kFixed, 1, ""});
  for (std::size_t i = 1; i < joint.size(); ++i) {
    const AtomInfo& atom = bridged.theory.atoms[i - 1];
    if (atom.role != Role::kFixed) theory.atoms[static_cast<std::size_t>(joint[i]) - 1] = atom;
  }
  const auto add = [&](const Clause& clause) {
    Clause& added = theory.clauses.emplace_back();
    for (const Literal literal : clause) {
      const Atom atom = joint[static_cast<std::size_t>(AtomOf(literal))];
      added.push_back(literal > 0 ? atom : -atom);
    }
  };
  for (const Clause& clause : bridged.theory.clauses) add(clause);
  for (const Literal latch : bridged.latches) add({latch});
  return theory;
}

Model LayeredModels::Read() {
  Model model(static_cast<std::size_t>(atoms_));
  for (Atom atom = 1; atom <= atoms_; ++atom) {
    if (solver_->Value(atom)) model.Make(atom);
  }
  return model;
}

SatResult LayeredModels::Check(const Model& model) {
  SatResult all = SatResult::kUnsatisfiable;
  Model lower;
  for (const Part& part : parts_) {
    const SatResult result = part.below->Below(model, 0, lower);
    if (result == SatResult::kLimit) return result;
    if (result == SatResult::kUnsatisfiable) continue;
    part.below->Learn(model, lower);
    part.formulas->Learn(*solver_, model, lower);
    all = SatResult::kSatisfiable;
  }
  return all;
}

SatResult LayeredModels::Find(std::span<const Literal> required, Model& model) {
  for (std::size_t calls = 0; calls < options_.calls; calls += 1 + parts_.size()) {
    for (const Part& part : parts_) solver_->Assume(part.formulas->guard());
    solver_->Assume(required);
    const SatResult result = solver_->Solve(options_.conflicts);
    if (result != SatResult::kSatisfiable) return result;
    model = Read();
    const SatResult below = Check(model);
    if (below == SatResult::kLimit) return below;
    if (below == SatResult::kUnsatisfiable) return SatResult::kSatisfiable;
  }
  return SatResult::kLimit;
}

Verdict LayeredModels::HasModel() {
  Model model;
  return ToVerdict(Find({}, model));
}

Answer LayeredModels::Entails(std::span<const Literal> clause) {
  std::vector<Literal> negation;
  for (const Literal literal : clause) negation.push_back(-Joint(0, literal));
  Model model;
  switch (Find(negation, model)) {
    case SatResult::kSatisfiable:
      return {Verdict::kNo, Basis::kWitness};
    case SatResult::kUnsatisfiable:
      return {Verdict::kYes, Basis::kAllMinimal};
    case SatResult::kLimit:
      break;
  }
  return {};
}

GoalStatus LayeredModels::Decide(std::size_t layer, Atom goal) {
  const Literal holds = Joint(layer, goal);
  const Literal fails = -holds;
  Model model;
  const SatResult with = Find({&holds, 1}, model);
  const SatResult without = Find({&fails, 1}, model);
  if (with == SatResult::kLimit || without == SatResult::kLimit) return GoalStatus::kUnknown;
  if (with == SatResult::kUnsatisfiable) return GoalStatus::kRefuted;
  return without == SatResult::kUnsatisfiable ? GoalStatus::kProved : GoalStatus::kOpen;
}

Verdict LayeredModels::IsConsistentWithTransfers() {
  for (Atom atom = first_ab_.front(); atom <= atoms_; ++atom) solver_->Assume(-atom);
  return ToVerdict(solver_->Solve(options_.conflicts));
}

}  // namespace latchwork::circumscription
