// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_PARAMETER_VALUE_H_
#define LATCHWORK_SDK_PARAMETER_VALUE_H_

#include <optional>
#include <string>
#include <string_view>

#include "latchwork/sdk/contract.h"
#include "latchwork/sdk/parameters.h"

namespace latchwork::sdk {

/// The value that `text` stands for, or nothing when it is not of the spec's type, not finite, out
/// of its range or none of its choices.
std::optional<Parameters::Value> ParseParameter(const ParameterSpec& spec, std::string_view text);

/// What the spec allows: "a number from 0 to 1 (m)", "'walls' or 'cells'".
std::string Allowed(const ParameterSpec& spec);

/// Any value of the spec's type, for a parameter that has none because of an error reported
/// elsewhere.
Parameters::Value NoValue(ParameterType type);

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_PARAMETER_VALUE_H_
