// SPDX-License-Identifier: BSD-3-Clause
#include "core/schedule/fork_join.h"

namespace latchwork::schedule {

ForkJoin::ForkJoin(unsigned threads) {
  for (unsigned i = 1; i < threads; ++i) {
    workers_.emplace_back([this](const std::stop_token& stop) { Work(stop); });
  }
}

void ForkJoin::Run(std::size_t count, const std::function<void(std::size_t)>& job) {
  if (workers_.empty() || count < 2) {
    for (std::size_t i = 0; i < count; ++i) job(i);
    return;
  }
  std::unique_lock lock(mutex_);
  job_ = &job;
  next_ = 0;
  count_ = count;
  unfinished_ = count;
  wake_.notify_all();
  TakeJobs(lock);
  done_.wait(lock, [&] { return unfinished_ == 0; });
}

void ForkJoin::Work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, stop, [&] { return next_ < count_; })) TakeJobs(lock);
}

void ForkJoin::TakeJobs(std::unique_lock<std::mutex>& lock) {
  while (next_ < count_) {
    const std::size_t mine = next_++;
    lock.unlock();
    (*job_)(mine);
    lock.lock();
    if (--unfinished_ == 0) done_.notify_all();
  }
}

}  // namespace latchwork::schedule
