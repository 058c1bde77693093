// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_STORAGE_DATABASE_H_
#define LATCHWORK_APPS_COMPARE_STORAGE_DATABASE_H_

#include <filesystem>
#include <map>
#include <string>

#include "apps/compare/runs/run_record.h"

namespace latchwork::compare {

/// Writes an SQLite database afresh, with the tables `runs` and `layers`: what is the same whenever
/// and wherever the runs are made, so that the same runs give the same bytes. Empty, or why it
/// could not be written.
std::string WriteResults(const std::filesystem::path& file,
                         const std::map<RunKey, RunRecord>& records);
/// The same of `run_times` and `layer_times`: what differs from run to run.
std::string WriteTimings(const std::filesystem::path& file,
                         const std::map<RunKey, RunRecord>& records);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_STORAGE_DATABASE_H_
