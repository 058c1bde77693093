// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_DERIVATION_H_
#define LATCHWORK_PTTP_DERIVATION_H_

#include "latchwork/sdk/decision.h"
#include "reasoners/pttp/search/engine.h"
#include "reasoners/pttp/search/machine.h"

namespace latchwork::pttp {

/// Writes down a proof that was recorded: premises before what they prove, the first start goal
/// last. To be called while the proof is valid.
sdk::Derivation MakeDerivation(const Proof& proof, const Engine& engine);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_DERIVATION_H_
