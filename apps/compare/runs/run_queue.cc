// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/run_queue.h"

#include <mutex>
#include <string>
#include <thread>

namespace latchwork::compare {

std::optional<RunRecord> MakeRun(const PlannedRun& run, const RunCommand& command,
                                 const std::atomic<bool>& stop) {
  std::vector<std::string> arguments = command.launch.arguments;
  arguments.insert(arguments.end(), run.arguments.begin(), run.arguments.end());
  arguments.insert(arguments.end(), {"--json", "--quiet"});
  const process::ChildResult child =
      process::RunChild(command.launch.program, arguments, command.limits, stop);
  if (child.end == process::ChildResult::End::kStopped) return std::nullopt;
  return Judge(run, child);
}

void MakeRuns(const std::vector<PlannedRun>& runs, const QueueOptions& options,
              std::atomic<bool>& stop) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  const auto work = [&] {
    while (!stop) {
      const std::size_t index = next++;
      if (index >= runs.size()) return;
      const auto record = MakeRun(runs[index], options.command, stop);
      if (!record) return;
      const std::lock_guard lock(mutex);
      if (!options.on_done(*record)) stop = true;
    }
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 1; i < options.jobs; ++i) workers.emplace_back(work);
  work();
}

}  // namespace latchwork::compare
