// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CORE_PROCESS_CHILD_PROCESS_H_
#define LATCHWORK_CORE_PROCESS_CHILD_PROCESS_H_

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/process/limits.h"

namespace latchwork::process {

/// How a process ended, and what it said.
struct ChildResult {
  enum class End { kExited, kSignalled, kTimedOut, kStopped, kNotStarted };
  End end = End::kNotStarted;
  int code = 0;        ///< Exit code, or the number of the signal.
  std::string output;  ///< Standard output, up to 16 MB.
  std::string errors;  ///< The last 4 KB of standard error, or why it was not started.
  double wall_seconds = 0;
  double cpu_seconds = 0;
};

/// Runs a program to its end within limits: wall time (then it is killed, with what it started) and
/// address space. `input` is its standard input. `stop`, set by anyone, ends it. Thread rule: safe
/// from any thread.
ChildResult RunChild(const std::filesystem::path& program,
                     const std::vector<std::string>& arguments, const Limits& limits,
                     const std::atomic<bool>& stop, std::string_view input = {});

/// The same for `work`, in a copy of this process; what it returns is the exit code, and its
/// processor time counts from the copying. The copy ends as soon as `work` returns and standard
/// output is written: nothing else is torn down. Thread rule: this process has one thread, which
/// lives as long as the copy.
ChildResult RunForked(const std::function<int()>& work, const Limits& limits,
                      const std::atomic<bool>& stop);

}  // namespace latchwork::process

#endif  // LATCHWORK_CORE_PROCESS_CHILD_PROCESS_H_
