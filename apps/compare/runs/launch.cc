// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/launch.h"

namespace latchwork::compare {

Launch LaunchOf(const std::filesystem::path& program,
                const std::vector<std::filesystem::path>& plugin_folders) {
  Launch launch{program, {}};
  for (const std::filesystem::path& folder : plugin_folders) {
    launch.arguments.emplace_back("--plugin-path");
    launch.arguments.push_back(std::filesystem::absolute(folder).string());
  }
  return launch;
}

}  // namespace latchwork::compare
