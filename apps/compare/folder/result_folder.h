// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_FOLDER_RESULT_FOLDER_H_
#define LATCHWORK_APPS_COMPARE_FOLDER_RESULT_FOLDER_H_

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "apps/compare/report/result_files.h"
#include "apps/compare/runs/run_record.h"
#include "apps/compare/storage/run_log.h"

namespace latchwork::compare {

/// What stopped the work on an experiment.
struct Trouble {
  enum class Kind { kNone, kInput, kWriting };
  Kind kind = Kind::kNone;
  std::string text;  ///< Whole lines, for people.
};

/// The folder of an experiment: which runs are done, which are missing, and its results. Whoever
/// makes the runs, and wherever, works on one of these. Nobody else writes to the folder as long as
/// the object lives. Thread rule: one thread at a time. `experiment` outlives it.
class ResultFolder {
 public:
  /// Makes the folder, or opens it as it was left.
  ResultFolder(const Experiment& experiment, std::filesystem::path folder);

  /// The first trouble stays; then nothing more is kept or written.
  const Trouble& trouble() const { return trouble_; }

  /// Keeps what another folder of the same experiment holds and this one does not.
  void TakeOver(const std::filesystem::path& folder);

  std::vector<PlannedRun> Missing(const Shard& shard = {}) const;

  /// Keeps a run that ended. False ends the work: it could not be written, or it could not begin,
  /// and then the experiment is wrong.
  bool Keep(const RunRecord& record);

  /// Writes everything but the log, from what the log holds. The report for people, empty on
  /// trouble.
  std::string WriteResults(const Origin& origin = {});

 private:
  bool Belong(const std::map<RunKey, RunRecord>& runs, const std::filesystem::path& folder);
  void Stop(Trouble::Kind kind, std::string text);

  const Experiment& experiment_;
  std::filesystem::path folder_;
  Trouble trouble_;
  RunLog log_;
};

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_FOLDER_RESULT_FOLDER_H_
