// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_OPTIONS_H_
#define LATCHWORK_PTTP_OPTIONS_H_

#include <span>

#include "latchwork/sdk/contract.h"
#include "latchwork/sdk/parameters.h"
#include "reasoners/pttp/strategies/prover.h"

namespace latchwork::pttp {

/// What `<param>` sets where the prover drives a layer. These tables feed the checks, the help and
/// the documentation.
std::span<const sdk::ParameterSpec> LayerOptions();

/// What the command line sets where a problem is proved: option `max_depth` by `--max-depth`.
std::span<const sdk::ParameterSpec> ProblemOptions();

/// The values of ProblemOptions(), as Prove() takes them; proof, answers, texts, deadline and
/// cancellation are left as they are by default.
ProverOptions OptionsFrom(const sdk::Parameters& values);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_OPTIONS_H_
