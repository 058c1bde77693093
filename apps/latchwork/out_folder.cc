// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/out_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace latchwork::app {

OutFolder::OutFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) {
    problem_ = fmt::format("cannot make the folder {}: {}", folder_.string(), error.message());
    return;
  }
  descriptor_ = open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  if (errno == EWOULDBLOCK) {
    problem_ =
        fmt::format("another run is writing to {}; give --out another folder", folder_.string());
  }
}

OutFolder::~OutFolder() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace latchwork::app
