// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/storage/run_log.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

namespace latchwork::compare {

LoggedRuns ReadRunLog(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  LoggedRuns logged;
  for (std::size_t end = text.find('\n'); end != std::string::npos;
       end = text.find('\n', logged.whole_bytes)) {
    const std::string_view line =
        std::string_view(text).substr(logged.whole_bytes, end - logged.whole_bytes);
    auto record = FromLine(line);
    if (!record) {
      logged.problem = file.string() + " holds a line that is no run; move it away to start afresh";
      return logged;
    }
    const RunKey key = record->key;
    logged.runs.insert_or_assign(key, std::move(*record));
    logged.whole_bytes = end + 1;
  }
  return logged;
}

RunLog::RunLog(const std::filesystem::path& file)
    : file_(file), descriptor_(open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) {
    logged_.problem = file.string() + ": " + std::strerror(errno);
  } else if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    logged_.problem = file.string() + " is being written by another process";
  } else {
    logged_ = ReadRunLog(file);
    const auto whole = static_cast<off_t>(logged_.whole_bytes);
    if (logged_.problem.empty() && ftruncate(descriptor_, whole) != 0) {
      logged_.problem = file.string() + ": " + std::strerror(errno);
    }
  }
}

RunLog::~RunLog() {
  if (descriptor_ >= 0) close(descriptor_);
}

bool RunLog::Add(const RunRecord& record) {
  if (!logged_.problem.empty()) return false;
  const std::string line = ToLine(record) + '\n';
  if (write(descriptor_, line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
    logged_.problem = file_.string() + " cannot be written: " + std::strerror(errno);
    return false;
  }
  logged_.runs.insert_or_assign(record.key, record);
  return true;
}

}  // namespace latchwork::compare
