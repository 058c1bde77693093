// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/run_queue.h"

#include <chrono>
#include <cstddef>
#include <mutex>
#include <thread>

namespace latchwork::compare {

using namespace std::chrono_literals;

constexpr auto kLookAround = 50ms;  // For `stop`, while a run lasts.

std::optional<RunRecord> MakeRun(ForkServer& server, const Task& task,
                                 const std::atomic<bool>& stop) {
  server.Begin(task);
  while (!stop) {
    if (auto record = server.Wait(kLookAround)) return record;
  }
  server.End();
  return std::nullopt;
}

void MakeRuns(const std::vector<PlannedRun>& runs, const QueueOptions& options,
              std::atomic<bool>& stop) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  const auto work = [&] {
    ForkServer server(options.launch);
    while (!stop) {
      const std::size_t index = next++;
      if (index >= runs.size()) return;
      const auto record = MakeRun(server, {runs[index], options.limits}, stop);
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
