// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_COMMAND_H_
#define LATCHWORK_APPS_LATCHWORK_COMMAND_H_

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace latchwork::app {

/// The documented exit codes, the same for every subcommand.
enum ExitCode : int {
  kDone = 0,
  kGoalNotReached = 1,
  kUsage = 2,
  kInvalidInput = 3,
  kPluginFailure = 4,
  kInternalError = 5,
  kDiverged = 6,
  kDeadlineMissed = 7,
};

/// What all subcommands share. Filled by main before a subcommand's callback runs.
struct Context {
  std::filesystem::path executable;  ///< Of this process, for finding plugins beside it.
  std::vector<std::filesystem::path> plugin_folders;  ///< --plugin-path, searched first.
  int exit_code = kDone;                              ///< Set by the callback of the subcommand.
  /// Does what a command line says, its first word being the program, and returns the exit code.
  std::function<int(const std::vector<std::string>& words, Context& context)> execute;
  /// Told of the libraries of the plugins of each run; may be empty.
  std::function<void(const std::filesystem::path& library)> used;
};

/// Each adds one subcommand with its options and a callback that does the work and sets
/// `context.exit_code`. `context` outlives `app`. Results go to standard output, progress and
/// diagnostics to standard error.
void AddRun(CLI::App& app, Context& context);
void AddCheck(CLI::App& app, Context& context);
void AddProve(CLI::App& app, Context& context);
void AddCheckProof(CLI::App& app, Context& context);
void AddEntail(CLI::App& app, Context& context);
void AddSemantics(CLI::App& app, Context& context);
void AddExplain(CLI::App& app, Context& context);
void AddCompare(CLI::App& app, Context& context);
void AddForkServer(CLI::App& app, Context& context);
void AddDiffReasoners(CLI::App& app, Context& context);
void AddReplay(CLI::App& app, Context& context);
void AddIcarus(CLI::App& app, Context& context);
void AddPlugin(CLI::App& app, Context& context);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_COMMAND_H_
