// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_RUNS_SERVE_RUNS_H_
#define LATCHWORK_APPS_COMPARE_RUNS_SERVE_RUNS_H_

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace latchwork::compare {

/// The subcommand of latchwork that is a fork server, and its first line.
inline constexpr std::string_view kForkServerCommand = "fork-server";
inline constexpr std::string_view kReady = "ready";

/// What a fork server does for its runs.
struct RunService {
  /// Makes the run of a command line, in a process of its own, and returns its exit code. What is
  /// told to `used` are libraries that it has loaded.
  std::function<int(const std::vector<std::string>& arguments,
                    const std::function<void(const std::filesystem::path& library)>& used)>
      run;
  /// Loads a library into the server, once each, after the first run that has used it has ended by
  /// itself: what cannot be loaded ends a run and not the server.
  std::function<void(const std::filesystem::path& library)> load;
};

/// A fork server: reads tasks (see ToText), one a line, and answers each with the record of its run
/// (see ToLine). Ends with what it reads, or when `stop` is set. False: it was told something else.
/// Thread rule: the only one of its process.
bool ServeRuns(const RunService& service, int input, int output, const std::atomic<bool>& stop);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_RUNS_SERVE_RUNS_H_
