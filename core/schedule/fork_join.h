// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_FORK_JOIN_H_
#define LATCHWORK_SCHEDULE_FORK_JOIN_H_

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace latchwork::schedule {

/// Does a batch of independent jobs on a fixed number of threads, the caller's among them.
class ForkJoin {
 public:
  explicit ForkJoin(unsigned threads);

  /// Calls job(0) .. job(count-1), each once, in any order, and returns when all have returned.
  /// `job` must not throw.
  void Run(std::size_t count, const std::function<void(std::size_t)>& job);

 private:
  void Work(const std::stop_token& stop);
  void TakeJobs(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::condition_variable_any done_;
  const std::function<void(std::size_t)>* job_ = nullptr;
  std::size_t next_ = 0;
  std::size_t count_ = 0;
  std::size_t unfinished_ = 0;
  std::vector<std::jthread> workers_;
};

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_FORK_JOIN_H_
