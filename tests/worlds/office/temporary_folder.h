// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_WORLDS_OFFICE_TEMPORARY_FOLDER_H_
#define LATCHWORK_TESTS_WORLDS_OFFICE_TEMPORARY_FOLDER_H_

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace latchwork::office {

/// A folder of one test, gone when the test is.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::path(testing::TempDir()) /
            (std::string("latchwork_") + info->test_suite_name() + "_" + info->name() + "_" +
             std::to_string(getpid()));
    std::filesystem::create_directories(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path Write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::filesystem::path ShippedFolder() {
  return std::filesystem::path(LATCHWORK_SOURCE_DIR) / "worlds/office";
}

}  // namespace latchwork::office

#endif  // LATCHWORK_TESTS_WORLDS_OFFICE_TEMPORARY_FOLDER_H_
