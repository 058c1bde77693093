// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/interruption.h"

#include <csignal>

namespace latchwork::app {
namespace {

// A signal handler is given nothing, so this is the process's, and hidden here.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void Interrupt(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

std::atomic<bool>& WatchForInterruption() {
  std::signal(SIGINT, Interrupt);
  std::signal(SIGTERM, Interrupt);
  return interrupted;
}

}  // namespace latchwork::app
