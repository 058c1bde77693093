// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_INPUT_TEXT_H_
#define LATCHWORK_APPS_LATCHWORK_INPUT_TEXT_H_

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::app {

/// The text of a file, "-" being standard input; nothing, and why in `diagnostics`, when it cannot
/// be read or is larger than 256 MiB.
std::optional<std::string> ReadInputText(const std::string& name, logic::Diagnostics& diagnostics);

/// All of standard input, at most one byte more than `most`. An input that cannot be read, a closed
/// one for instance, is not an empty one: nothing.
std::optional<std::string> ReadStandardInput(std::size_t most);

constexpr std::string_view kInputUnreadable = "standard input cannot be read: it is closed";

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_INPUT_TEXT_H_
