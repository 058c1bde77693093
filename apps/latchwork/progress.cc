// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace latchwork::app {
namespace {

constexpr std::chrono::milliseconds kFirst{500};
constexpr std::chrono::milliseconds kOnTerminal{100};
constexpr std::chrono::milliseconds kElsewhere{10'000};

}  // namespace

Progress::Progress(std::string_view what, bool quiet)
    : what_(what),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      next_(start_ + (terminal_ ? kFirst : kElsewhere)) {}

Progress::~Progress() {
  if (drawn_ && terminal_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::Update(std::uint64_t done, std::uint64_t total) {
  if (quiet_ || total == 0) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + (terminal_ ? kOnTerminal : kElsewhere);
  Draw(now, static_cast<double>(done) / static_cast<double>(total));
}

void Progress::Draw(Clock::time_point now, double share) {
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double left = share > 0 ? seconds * (1 - share) / share : 0;
  fmt::print(stderr, "{}{}: {:3.0f} %, at most {:.0f} s left{}", terminal_ ? "\r\x1b[K" : "", what_,
             100 * share, left, terminal_ ? "" : "\n");
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace latchwork::app
