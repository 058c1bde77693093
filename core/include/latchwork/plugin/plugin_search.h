// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGIN_PLUGIN_SEARCH_H_
#define LATCHWORK_PLUGIN_PLUGIN_SEARCH_H_

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace latchwork::plugin {

/// The folders in which plugins are looked for, in order: those given (--plugin-path), those of
/// `environment` (separated by colons), and, seen from the folder of the executable, ../plugins (in
/// a build tree) and ../lib/latchwork/plugins (installed). Absolute, each once. They need not
/// exist.
std::vector<std::filesystem::path> MakeSearchPath(std::span<const std::filesystem::path> given,
                                                  std::string_view environment,
                                                  const std::filesystem::path& executable);

/// The same with the environment variable LATCHWORK_PLUGIN_PATH of this process.
std::vector<std::filesystem::path> MakeSearchPath(std::span<const std::filesystem::path> given,
                                                  const std::filesystem::path& executable);

/// What a folder of the search path holds.
struct SearchedFolder {
  std::filesystem::path path;
  std::vector<std::filesystem::path>
      files;            ///< Its *.so, sorted by name; subfolders are not searched.
  std::string problem;  ///< Why it was not searched; empty when it was.
};

/// Looks into every folder. A file that is reached twice (the same real path) counts where it is
/// reached first.
std::vector<SearchedFolder> SearchPlugins(std::span<const std::filesystem::path> folders);

}  // namespace latchwork::plugin

#endif  // LATCHWORK_PLUGIN_PLUGIN_SEARCH_H_
