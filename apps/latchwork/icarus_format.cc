// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/unified_diff.h"
#include "reasoners/icarus/language/reader.h"
#include "reasoners/icarus/tools/formatter.h"

namespace latchwork::app {
namespace {

struct Settings {
  std::vector<std::string> files;
  bool check = false;
  bool diff = false;
};

/// The new text stands beside the old one until it is whole. Links stay links, and permissions what
/// they are.
bool Replace(const std::string& file, const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path target = fs::canonical(file, error);
  const fs::file_status before = fs::status(target, error);
  const fs::path fresh = target.string() + ".formatted";
  std::ofstream stream(fresh, std::ios::binary);
  if (stream) fs::permissions(fresh, before.permissions(), error);
  stream << text;
  stream.close();
  if (stream && !error) fs::rename(fresh, target, error);
  if (stream && !error) return true;
  fs::remove(fresh, error);
  fmt::print(stderr, "{}: error: the file cannot be written\n", file);
  return false;
}

int FormatFile(const Settings& settings, const std::string& file) {
  std::optional<std::string> text = ReadProgramText(file);
  if (!text) return kInvalidInput;
  const std::string before = *text;
  icarus::Findings findings;
  const icarus::SourceTree tree = icarus::ReadForms(*std::move(text), file, findings);
  if (!findings.empty()) {
    PrintFindings(file, findings);
    return kInvalidInput;
  }
  const std::string after = icarus::FormatProgram(tree);
  if (settings.diff) {
    fmt::print("{}", UnifiedDiff(before, after, file));
    return before == after ? kDone : kGoalNotReached;
  }
  if (file == "-" && !settings.check) {
    fmt::print("{}", after);
    return kDone;
  }
  if (before == after) return kDone;
  fmt::print("{}\n", file);
  if (settings.check) return kGoalNotReached;
  return Replace(file, after) ? kDone : kInvalidInput;
}

}  // namespace

void AddIcarusFormat(CLI::App& icarus, Context& context) {
  CLI::App* command = icarus.add_subcommand(
      "fmt", "Give programs their canonical layout, in place; prints which were changed");
  const auto settings = std::make_shared<Settings>();
  command->add_option("FILE", settings->files, "Programs; - is standard input, to standard output")
      ->required();
  command->add_flag("--check", settings->check,
                    "Change nothing; exit with 1 when a program would be changed");
  command->add_flag("--diff", settings->diff,
                    "Change nothing; print what would be changed, for people and for 'patch', and "
                    "exit with 1 where something would be");
  command->callback([settings, &context] {
    for (const std::string& file : settings->files) {
      context.exit_code = std::max(context.exit_code, FormatFile(*settings, file));
    }
  });
}

}  // namespace latchwork::app
