// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_OPTIONS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_OPTIONS_H_

#include <cstdint>
#include <span>

#include "latchwork/sdk/contract.h"
#include "latchwork/sdk/parameters.h"

namespace latchwork::circumscription {

enum class Mode : std::uint8_t { kAuto, kExact, kBounded };

/// What `<param>` sets where this reasoner drives a layer; the prover's options apply where bodies
/// are decided by bounded proof.
std::span<const sdk::ParameterSpec> LayerOptions();

Mode ModeOf(const sdk::Parameters& parameters);
/// Whether conclusions are those of some minimal model, not of all.
bool IsBrave(const sdk::Parameters& parameters);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_OPTIONS_H_
