// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_CORE_PLUGIN_PLUGIN_FOLDERS_H_
#define LATCHWORK_TESTS_CORE_PLUGIN_PLUGIN_FOLDERS_H_

#include <filesystem>

namespace latchwork::plugin {

inline const std::filesystem::path kSamples =
    std::filesystem::path(LATCHWORK_BINARY_DIR) / "sample_plugins";
inline const std::filesystem::path kFaults =
    std::filesystem::path(LATCHWORK_BINARY_DIR) / "fault_plugins";

}  // namespace latchwork::plugin

#endif  // LATCHWORK_TESTS_CORE_PLUGIN_PLUGIN_FOLDERS_H_
