// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_PROGRESS_H_
#define LATCHWORK_APPS_LATCHWORK_PROGRESS_H_

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace latchwork::app {

/// Tells a person on standard error how far long work has come: a line that is redrawn on a
/// terminal, a line every ten seconds elsewhere. Silent when quiet, and for work that ends within
/// half a second. Thread rule: one thread.
class Progress {
 public:
  Progress(std::string_view what, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void Update(std::uint64_t done, std::uint64_t total);

 private:
  using Clock = std::chrono::steady_clock;
  void Draw(Clock::time_point now, double share);

  std::string what_;
  bool quiet_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_;
  Clock::time_point next_;
};

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_PROGRESS_H_
