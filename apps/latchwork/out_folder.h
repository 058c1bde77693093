// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_OUT_FOLDER_H_
#define LATCHWORK_APPS_LATCHWORK_OUT_FOLDER_H_

#include <filesystem>
#include <string>

namespace latchwork::app {

/// The folder that one run writes to: made where there is none, and closed to all other runs, of
/// this process or another, while this lives.
class OutFolder {
 public:
  explicit OutFolder(std::filesystem::path folder);
  ~OutFolder();
  OutFolder(const OutFolder&) = delete;
  OutFolder& operator=(const OutFolder&) = delete;

  /// Why nothing can be written here; empty when all is well.
  const std::string& problem() const { return problem_; }

 private:
  std::filesystem::path folder_;
  int descriptor_ = -1;
  std::string problem_;
};

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_OUT_FOLDER_H_
