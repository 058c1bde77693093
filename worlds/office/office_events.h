// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_OFFICE_EVENTS_H_
#define LATCHWORK_OFFICE_OFFICE_EVENTS_H_

#include <span>
#include <string>

#include "latchwork/logic/atom.h"
#include "latchwork/sdk/contract.h"
#include "worlds/office/office_state.h"

namespace latchwork::office {

/// Lets an event of OfficeEvents (`known`) happen. Empty, or why it cannot happen: then nothing has
/// changed.
std::string ApplyEvent(const logic::Fact& event, std::span<const sdk::PredicateSpec> known,
                       OfficeState& state);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_OFFICE_EVENTS_H_
