// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_SETTINGS_H_
#define LATCHWORK_APPS_LATCHWORK_SETTINGS_H_

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "latchwork/config/agent.h"

namespace latchwork::app {

/// What the option --set was given: "world.people=4" or "avoid.reasoner.depth=12". Throws
/// CLI::ValidationError for what has not that shape.
std::vector<config::Override> ParseSettings(const std::vector<std::string>& settings);

/// Lets digits through, for a value from `least` to `most`; CLI11 by itself takes -1 for the
/// largest number there is.
CLI::Validator WholeNumber(std::uint64_t least = 0,
                           std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// Lets anything through but an empty text, which a variable of a script may have become.
CLI::Validator NotEmpty();

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_SETTINGS_H_
