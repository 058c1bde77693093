// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_INPUT_TEXT_H_
#define LATCHWORK_APPS_LATCHWORK_INPUT_TEXT_H_

#include <optional>
#include <string>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::app {

/// The text of a file, "-" being standard input; nothing, and why in `diagnostics`, when it cannot
/// be read or is larger than 256 MiB.
std::optional<std::string> ReadInputText(const std::string& name, logic::Diagnostics& diagnostics);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_INPUT_TEXT_H_
