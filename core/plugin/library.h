// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGIN_LIBRARY_H_
#define LATCHWORK_PLUGIN_LIBRARY_H_

#include <filesystem>
#include <memory>
#include <string>

#include "latchwork/sdk/plugin.h"

namespace latchwork::plugin {

/// What a plugin made, or why it made nothing; `problem` carries the dynamic loader's own words.
struct MadeObject {
  std::shared_ptr<void>
      object;  ///< A sdk::Layer, sdk::Reasoner or sdk::World, as `kind` of the record says.
  std::string problem;
};

/// Loads the plugin and lets it make an object. `expected` is the record that was read from the
/// file and found to fit; that in memory must be the same. All symbols are resolved at once and
/// seen by nobody else. The library stays loaded as long as the object lives. Thread rule: may be
/// called from any thread.
MadeObject MakeObject(const std::filesystem::path& file, const sdk::PluginInfo& expected);

}  // namespace latchwork::plugin

#endif  // LATCHWORK_PLUGIN_LIBRARY_H_
