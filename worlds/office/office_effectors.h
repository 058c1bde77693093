// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_OFFICE_EFFECTORS_H_
#define LATCHWORK_OFFICE_OFFICE_EFFECTORS_H_

#include <optional>
#include <span>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/world.h"
#include "worlds/office/office_state.h"

namespace latchwork::office {

/// Does what the effectors of the office are told. A command that merely stands is told again in
/// every tick, with `updated` false. Thread rule: used by one thread.
class OfficeEffectors {
 public:
  explicit OfficeEffectors(logic::SymbolTable& symbols);

  /// One batch for each EffectorPort.
  void Apply(std::span<const sdk::Batch> effectors, OfficeState& state);

 private:
  void Drive(const sdk::Batch& batch, Vehicle& vehicle);
  void PressButtons(const sdk::Batch& batch, OfficeState& state) const;

  logic::Symbol fwd_, turn_, halt_, call_, ride_;
  std::optional<double> last_turn_;
};

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_OFFICE_EFFECTORS_H_
