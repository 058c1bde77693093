// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_STORAGE_RUN_LOG_H_
#define LATCHWORK_APPS_COMPARE_STORAGE_RUN_LOG_H_

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "apps/compare/runs/run_record.h"

namespace latchwork::compare {

/// The runs that are done, one line each, in the order in which they ended. What was killed while
/// it wrote leaves at most a torn last line, which is dropped.
class RunLog {
 public:
  /// Opens or makes the log of an experiment; `problem` says why it cannot.
  explicit RunLog(const std::filesystem::path& file);

  const std::string& problem() const { return problem_; }
  const std::map<RunKey, RunRecord>& done() const { return done_; }
  /// False: it could not be written.
  bool Add(const RunRecord& record);

 private:
  std::string problem_;
  std::map<RunKey, RunRecord> done_;
  std::ofstream stream_;
};

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_STORAGE_RUN_LOG_H_
