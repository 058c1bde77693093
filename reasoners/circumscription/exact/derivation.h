// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_DERIVATION_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_DERIVATION_H_

#include <span>
#include <string>

#include "latchwork/sdk/decision.h"
#include "reasoners/circumscription/evaluation/evaluator.h"

namespace latchwork::circumscription {

/// The steps that lead to a fact of the last evaluation, each once, premises first. `ports`: names
/// of the latches.
sdk::Derivation DeriveFact(const Evaluator& evaluator, FactRef fact,
                           std::span<const std::string> ports);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_DERIVATION_H_
