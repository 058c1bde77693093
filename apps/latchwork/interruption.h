// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_INTERRUPTION_H_
#define LATCHWORK_APPS_LATCHWORK_INTERRUPTION_H_

#include <atomic>

namespace latchwork::app {

/// From now on SIGINT and SIGTERM only set what is returned, so that work can end in order and keep
/// what it has; the second of them ends the process.
std::atomic<bool>& WatchForInterruption();

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_INTERRUPTION_H_
