// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_RUNS_FORK_SERVER_H_
#define LATCHWORK_APPS_COMPARE_RUNS_FORK_SERVER_H_

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/runs/launch.h"
#include "apps/compare/runs/run_record.h"
#include "apps/compare/runs/task.h"
#include "core/process/companion.h"

namespace latchwork::compare {

/// The fork server of one worker: a process, `latchwork fork-server`, that loads what runs need
/// once and forks for each of them. It is started with the first run, and again when it died. Runs
/// are made one at a time. See ServeRuns for the other side. Thread rule: one thread, which ends
/// after this object: its process ends with the thread that started it.
class ForkServer {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ForkServer(const Launch& launch);
  ForkServer(const ForkServer&) = delete;
  ForkServer& operator=(const ForkServer&) = delete;
  ~ForkServer() { End(); }

  /// Begins a run in a process of its own. None is at hand.
  void Begin(const Task& task);
  bool is_busy() const { return task_.has_value(); }
  /// The record of the run at hand, once it has ended; waits for it for that long.
  std::optional<RunRecord> Wait(Clock::duration time);
  /// Ends the run at hand and the server.
  void End();

 private:
  std::optional<RunRecord> Hear(const std::string& line);
  RunRecord Lost(const std::string& why);

  std::filesystem::path program_;
  std::vector<std::string> arguments_;
  process::Companion process_;
  bool is_ready_ = false;
  std::optional<Task> task_;
  Clock::time_point last_;  ///< The run has ended by then, if the server lives.
};

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_RUNS_FORK_SERVER_H_
