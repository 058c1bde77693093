// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/storage/run_log.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>

namespace latchwork::compare {

LoggedRuns ReadRunLog(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  LoggedRuns logged;
  for (std::string line; std::getline(stream, line) && !stream.eof();) {
    auto record = FromLine(line);
    if (!record || record->outcome == Outcome::kInvalid) {
      logged.problem = file.string() + " holds a line that is no run; move it away to start afresh";
      return logged;
    }
    const RunKey key = record->key;
    logged.runs.insert_or_assign(key, std::move(*record));
    logged.whole_bytes += line.size() + 1;
  }
  return logged;
}

RunLog::RunLog(const std::filesystem::path& file)
    : file_(file), descriptor_(open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) {
    problem_ = file.string() + ": " + std::strerror(errno);
  } else if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    problem_ = file.string() + " is being written by another process";
  } else {
    Resume();
  }
}

void RunLog::Resume() {
  const LoggedRuns logged = ReadRunLog(file_);
  problem_ = logged.problem;
  for (const auto& [key, record] : logged.runs) done_.insert(key);
  if (problem_.empty() && ftruncate(descriptor_, static_cast<off_t>(logged.whole_bytes)) != 0) {
    problem_ = file_.string() + ": " + std::strerror(errno);
  }
}

RunLog::~RunLog() {
  if (descriptor_ >= 0) close(descriptor_);
}

bool RunLog::Add(const RunRecord& record) {
  if (!problem_.empty()) return false;
  const std::string line = ToLine(record) + '\n';
  if (write(descriptor_, line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
    problem_ = file_.string() + " cannot be written: " + std::strerror(errno);
    return false;
  }
  done_.insert(record.key);
  return true;
}

}  // namespace latchwork::compare
