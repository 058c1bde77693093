// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"

namespace {

constexpr latchwork::sdk::PluginInfo OfTheNextAbi() {
  latchwork::sdk::PluginInfo info = latchwork::sdk::MakePluginInfo(
      latchwork::sdk::PluginKind::kReasoner, "wrong_abi", "1.0", "speaks an ABI that is to come");
  ++info.abi;
  return info;
}

}  // namespace

// Only the record: no code of this plugin may ever be needed to find out that it does not fit.
// NOLINTBEGIN(readability-identifier-naming): the loader's name for it.
extern "C" {
__attribute__((
    visibility("default"))) extern const latchwork::sdk::PluginInfo latchwork_plugin_info;
__attribute__((used, section(".latchwork")))
const latchwork::sdk::PluginInfo latchwork_plugin_info = OfTheNextAbi();
}
// NOLINTEND(readability-identifier-naming)
