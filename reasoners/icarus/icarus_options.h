// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_ICARUS_OPTIONS_H_
#define LATCHWORK_ICARUS_ICARUS_OPTIONS_H_

#include <span>

#include "latchwork/sdk/contract.h"
#include "latchwork/sdk/parameters.h"
#include "reasoners/icarus/machine/interpreter.h"

namespace latchwork::icarus {

/// The parameters of the reasoner.
std::span<const sdk::ParameterSpec> LayerOptions();
RunOptions OptionsFrom(const sdk::Parameters& values);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_ICARUS_OPTIONS_H_
