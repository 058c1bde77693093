// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_RUNS_LAUNCH_H_
#define LATCHWORK_APPS_COMPARE_RUNS_LAUNCH_H_

#include <filesystem>
#include <string>
#include <vector>

namespace latchwork::compare {

/// How a run is started.
struct Launch {
  std::filesystem::path program;       ///< latchwork.
  std::vector<std::string> arguments;  ///< Before those of the run.
};

/// With folders to search for plugins first.
Launch LaunchOf(const std::filesystem::path& program,
                const std::vector<std::filesystem::path>& plugin_folders);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_RUNS_LAUNCH_H_
