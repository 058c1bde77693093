// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGIN_ABI_CHECK_H_
#define LATCHWORK_PLUGIN_ABI_CHECK_H_

#include <string>
#include <vector>

#include "latchwork/sdk/plugin.h"

namespace latchwork::plugin {

/// Whether the fields after `size` of this record mean what they mean in this build.
bool HasKnownLayout(const sdk::PluginInfo& info);

/// What keeps a plugin with this record from being used by this build, in words, with the way to
/// mend it; empty when it fits. Compared are the ABI number, the C++ standard, the compiler's major
/// version, the standard library and the sanitizers: objects of standard types cross the boundary,
/// so all of them have to be the same.
std::vector<std::string> AbiDifferences(const sdk::PluginInfo& info);

}  // namespace latchwork::plugin

#endif  // LATCHWORK_PLUGIN_ABI_CHECK_H_
