// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGIN_PRELOAD_H_
#define LATCHWORK_PLUGIN_PRELOAD_H_

#include <filesystem>
#include <string>

namespace latchwork::plugin {

/// Loads the library of a plugin, to stay until this process ends: whoever makes its objects later,
/// here or in a copy of this process, finds it there. Nothing of it runs but what the dynamic
/// loader runs. Empty, or the loader's own words. Thread rule: may be called from any thread.
std::string Preload(const std::filesystem::path& file);

}  // namespace latchwork::plugin

#endif  // LATCHWORK_PLUGIN_PRELOAD_H_
