// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_PROVE_LIMITS_H_
#define LATCHWORK_APPS_LATCHWORK_PROVE_LIMITS_H_

#include <atomic>
#include <cstddef>
#include <string_view>

namespace latchwork::app {

/// Holds a proof attempt to its CPU time and memory, and to what signals ask for, so that exactly
/// one SZS status line comes out. When the time is over, or at SIGXCPU, SIGALRM, SIGTERM or SIGINT,
/// `cancelled` becomes true; if that does not end the attempt within a fraction of a second of CPU
/// time, or when memory runs out, the status line is written and the process ends at once with
/// kGoalNotReached. There is one for a process.
class ProveLimits {
 public:
  /// CPU seconds of all threads since the process began. Memory: the process's data, in MB; 0 is no
  /// limit. `file` is named in the status line, which with `json` is a JSON object instead.
  ProveLimits(double cpu_seconds, std::size_t memory_mb, std::string_view file, bool json);
  ~ProveLimits();
  ProveLimits(const ProveLimits&) = delete;
  ProveLimits& operator=(const ProveLimits&) = delete;

  static const std::atomic<bool>& cancelled();
  /// The SZS word for what ended the attempt; "" when nothing did.
  static std::string_view reason();
  /// To be called before the caller writes its own status line: from then on no other is written.
  void Release();
};

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_PROVE_LIMITS_H_
