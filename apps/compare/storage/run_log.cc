// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/storage/run_log.h"

#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

namespace latchwork::compare {
namespace {

std::string ReadAll(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

RunLog::RunLog(const std::filesystem::path& file) {
  const std::string text = ReadAll(file);
  std::size_t whole = 0;
  while (true) {
    const std::size_t end = text.find('\n', whole);
    if (end == std::string::npos) break;
    auto record = FromLine(std::string_view(text).substr(whole, end - whole));
    if (!record) {
      problem_ = file.string() + " holds a line that is no run; move it away to start afresh";
      return;
    }
    const RunKey key = record->key;
    done_.insert_or_assign(key, std::move(*record));
    whole = end + 1;
  }
  std::error_code error;
  if (whole < text.size()) std::filesystem::resize_file(file, whole, error);
  stream_.open(file, std::ios::binary | std::ios::app);
  if (error || !stream_) problem_ = file.string() + " cannot be written";
}

bool RunLog::Add(const RunRecord& record) {
  stream_ << ToLine(record) << '\n' << std::flush;
  done_.insert_or_assign(record.key, record);
  return static_cast<bool>(stream_);
}

}  // namespace latchwork::compare
