// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/office_effectors.h"

#include <cmath>

#include "worlds/office/office_contract.h"

namespace latchwork::office {

using logic::Fact;
using logic::Term;

OfficeEffectors::OfficeEffectors(logic::SymbolTable& symbols)
    : fwd_(symbols.Intern("fwd")),
      turn_(symbols.Intern("turn")),
      halt_(symbols.Intern("halt")),
      call_(symbols.Intern("call")),
      ride_(symbols.Intern("ride")) {}

void OfficeEffectors::Apply(std::span<const sdk::Batch> effectors, OfficeState& state) {
  Drive(effectors[kDrive], *state.vehicle);
  PressButtons(effectors[kButtons], state);
}

void OfficeEffectors::Drive(const sdk::Batch& batch, Vehicle& vehicle) {
  std::optional<double> speed;
  std::optional<double> turn;
  bool halt = false;
  for (const Fact& fact : batch.facts) {
    if (fact.predicate() == halt_) halt = true;
    if (fact.arity() != 1 || !fact.argument(0).is_number()) continue;
    const double value = fact.argument(0).number();
    if (!std::isfinite(value)) continue;
    // Several commands of a kind: the slowest, the smallest turn.
    if (fact.predicate() == fwd_ && (!speed || value < *speed)) speed = value;
    if (fact.predicate() == turn_ && (!turn || std::abs(value) < std::abs(*turn))) turn = value;
  }
  vehicle.Forward(halt ? std::optional(0.0) : speed);
  // A turn counts from the heading at which it was told; a command that merely stands is the same
  // turn.
  if (batch.updated || turn != last_turn_) vehicle.Turn(turn);
  last_turn_ = turn;
}

void OfficeEffectors::PressButtons(const sdk::Batch& batch, OfficeState& state) const {
  for (const Fact& fact : batch.facts) {
    if (fact.arity() != 2 || fact.argument(0).kind() != Term::Kind::kConstant) continue;
    if (fact.argument(1).kind() != Term::Kind::kInteger) continue;
    const auto elevator = state.building.FindElevator(fact.argument(0).symbol().name());
    const auto floor = state.building.FindFloor(fact.argument(1).integer());
    if (!elevator || !floor) continue;
    const bool inside = CabAt(state.building, state.place()) == elevator;
    Elevator& called = state.elevators[*elevator];
    if (fact.predicate() == ride_ && inside && *floor != called.floor()) called.Call(*floor);
    if (fact.predicate() == call_) called.Call(*floor);
  }
}

}  // namespace latchwork::office
