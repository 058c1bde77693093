// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"

// NOLINTBEGIN(readability-identifier-naming): the loader's name for it.
extern "C" {
__attribute__((
    visibility("default"))) extern const latchwork::sdk::PluginInfo latchwork_plugin_info;
__attribute__((used, section(".latchwork")))
const latchwork::sdk::PluginInfo latchwork_plugin_info = latchwork::sdk::MakePluginInfo(
    latchwork::sdk::PluginKind::kReasoner, "no_create", "1.0", "only a record");
}
// NOLINTEND(readability-identifier-naming)
