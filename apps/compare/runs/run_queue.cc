// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/run_queue.h"

#include <mutex>
#include <thread>

namespace latchwork::compare {

void MakeRuns(const std::vector<PlannedRun>& runs, const QueueOptions& options,
              std::atomic<bool>& stop) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  const auto work = [&] {
    while (!stop) {
      const std::size_t index = next++;
      if (index >= runs.size()) return;
      std::vector<std::string> arguments = options.arguments;
      arguments.insert(arguments.end(), runs[index].arguments.begin(), runs[index].arguments.end());
      arguments.insert(arguments.end(), {"--json", "--quiet"});
      const process::ChildResult child =
          process::RunChild(options.program, arguments, options.limits, stop);
      if (child.end == process::ChildResult::End::kStopped) return;
      const std::lock_guard lock(mutex);
      if (!options.on_done(Judge(runs[index], child))) stop = true;
    }
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 1; i < options.jobs; ++i) workers.emplace_back(work);
  work();
}

}  // namespace latchwork::compare
