// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_INTEGRATION_RUN_COMMAND_H_
#define LATCHWORK_TESTS_INTEGRATION_RUN_COMMAND_H_

#include <filesystem>
#include <string>
#include <vector>

namespace latchwork::testing {

struct CommandResult {
  int exit_code = -1;  ///< -1 when it did not end by itself.
  std::string out;
  std::string err;
};

/// Runs the built `latchwork` with these arguments in `folder` and waits for it.
CommandResult RunLatchwork(const std::vector<std::string>& arguments,
                           const std::filesystem::path& folder);

/// The same through a shell, in which `latchwork` is the built command: for standard input,
/// variables and signals.
CommandResult RunShell(const std::string& script, const std::filesystem::path& folder);

std::string ReadText(const std::filesystem::path& file);
void WriteText(const std::filesystem::path& file, const std::string& text);

}  // namespace latchwork::testing

#endif  // LATCHWORK_TESTS_INTEGRATION_RUN_COMMAND_H_
