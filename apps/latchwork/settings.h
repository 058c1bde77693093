// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_SETTINGS_H_
#define LATCHWORK_APPS_LATCHWORK_SETTINGS_H_

#include <string>
#include <vector>

#include "latchwork/config/agent.h"

namespace latchwork::app {

/// What the option --set was given: "world.people=4" or "avoid.reasoner.depth=12". Throws
/// CLI::ValidationError for what has not that shape.
std::vector<config::Override> ParseSettings(const std::vector<std::string>& settings);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_SETTINGS_H_
