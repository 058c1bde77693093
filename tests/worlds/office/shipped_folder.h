// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_WORLDS_OFFICE_SHIPPED_FOLDER_H_
#define LATCHWORK_TESTS_WORLDS_OFFICE_SHIPPED_FOLDER_H_

#include <filesystem>

namespace latchwork::office {

/// Where the world's own maps are.
inline std::filesystem::path ShippedFolder() {
  return std::filesystem::path(LATCHWORK_SOURCE_DIR) / "worlds/office";
}

}  // namespace latchwork::office

#endif  // LATCHWORK_TESTS_WORLDS_OFFICE_SHIPPED_FOLDER_H_
