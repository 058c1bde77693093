// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_STORAGE_RUN_LOG_H_
#define LATCHWORK_APPS_COMPARE_STORAGE_RUN_LOG_H_

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "apps/compare/runs/run_record.h"

namespace latchwork::compare {

/// The runs that are done, one line each, in the order in which they ended.
struct LoggedRuns {
  std::map<RunKey, RunRecord> runs;
  std::size_t whole_bytes = 0;  ///< What follows is a torn last line.
  std::string problem;          ///< Empty, or why the log cannot be read.
};

/// Leaves the file as it is.
LoggedRuns ReadRunLog(const std::filesystem::path& file);

/// A log that is written to. What was killed while it wrote leaves at most a torn last line, which
/// is dropped. Nobody else writes to it as long as this object lives. It remembers which runs are
/// done, not what they gave: there may be very many.
class RunLog {
 public:
  /// Opens or makes the file; problem() says why it cannot.
  explicit RunLog(const std::filesystem::path& file);
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;
  ~RunLog();

  /// Empty, or what went wrong; then nothing more is added.
  const std::string& problem() const { return problem_; }
  const std::set<RunKey>& done() const { return done_; }
  /// False: it could not be written.
  bool Add(const RunRecord& record);

 private:
  void Resume();

  std::filesystem::path file_;
  std::set<RunKey> done_;
  std::string problem_;
  int descriptor_ = -1;
};

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_STORAGE_RUN_LOG_H_
