// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_PLUGIN_PAGE_H_
#define LATCHWORK_APPS_LATCHWORK_PLUGIN_PAGE_H_

#include <string>
#include <vector>

#include "latchwork/plugin/registry.h"
#include "latchwork/sdk/layer.h"
#include "latchwork/sdk/reasoner.h"
#include "latchwork/sdk/world.h"

namespace latchwork::app {

/// What `latchwork plugin show` prints: contract, parameters, languages, events, and a fragment of
/// an agent file that is valid as it stands. Ends with a newline.
std::string PluginPage(const plugin::PluginEntry& entry, const sdk::Layer& layer);
std::string PluginPage(const plugin::PluginEntry& entry, const sdk::Reasoner& reasoner);
std::string PluginPage(const plugin::PluginEntry& entry, const sdk::World& world);

/// Rows as text, columns two spaces apart, each line after `indent`. The last column is not filled
/// up.
std::string TextTable(const std::vector<std::vector<std::string>>& rows, const std::string& indent);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_PLUGIN_PAGE_H_
