// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_CORE_PLUGIN_TEMPORARY_FOLDER_H_
#define LATCHWORK_TESTS_CORE_PLUGIN_TEMPORARY_FOLDER_H_

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace latchwork::plugin {

inline const std::filesystem::path kSamples =
    std::filesystem::path(LATCHWORK_BINARY_DIR) / "sample_plugins";
inline const std::filesystem::path kFaults =
    std::filesystem::path(LATCHWORK_BINARY_DIR) / "fault_plugins";

/// An empty folder that goes away with this object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "latchwork_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = std::filesystem::canonical(name);
  }
  ~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  std::filesystem::path Write(std::string_view name, std::string_view bytes) const {
    std::filesystem::path file = path_ / name;
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }
  std::filesystem::path Copy(const std::filesystem::path& from, std::string_view name) const {
    std::filesystem::path file = path_ / name;
    std::filesystem::copy_file(from, file);
    return file;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace latchwork::plugin

#endif  // LATCHWORK_TESTS_CORE_PLUGIN_TEMPORARY_FOLDER_H_
