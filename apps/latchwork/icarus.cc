// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/input_text.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::app {

std::optional<std::string> ReadProgramText(const std::string& file) {
  logic::Diagnostics diagnostics;
  std::optional<std::string> text = ReadInputText(file, diagnostics);
  fmt::print(stderr, "{}", logic::Format(diagnostics));
  return text;
}

void PrintFindings(const std::string& file, const icarus::Findings& findings) {
  std::size_t errors = 0;
  for (const icarus::Finding& finding : findings) {
    fmt::print(stderr, "{}", icarus::Format(finding));
    if (finding.severity == icarus::Severity::kError) ++errors;
  }
  const std::size_t warnings = findings.size() - errors;
  if (findings.empty()) return;
  fmt::print(stderr, "{}: {} error{}, {} warning{}\n", file, errors, errors == 1 ? "" : "s",
             warnings, warnings == 1 ? "" : "s");
}

void AddIcarus(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("icarus", "Check, format and run Icarus programs");
  command->require_subcommand(1);
  AddIcarusCheck(*command, context);
  AddIcarusFormat(*command, context);
  AddIcarusRun(*command, context);
  AddIcarusTrace(*command, context);
  AddIcarusRepl(*command, context);
  AddIcarusLearn(*command, context);
  AddIcarusRecord(*command, context);
  AddIcarusRecognise(*command, context);
  AddIcarusTranslate(*command, context);
}

}  // namespace latchwork::app
