// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include "apps/latchwork/icarus_command.h"
#include "reasoners/icarus/language/reader.h"

namespace latchwork::app {
namespace {

std::string ReadStream(std::istream& stream) {
  std::string text;
  std::array<char, 1U << 16U> buffer{};
  while (text.size() <= icarus::kMaxProgramBytes) {
    stream.read(buffer.data(), buffer.size());
    if (stream.gcount() == 0) break;
    text.append(buffer.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return text;
}

}  // namespace

std::optional<std::string> ReadProgramText(const std::string& file) {
  if (file == "-") return ReadStream(std::cin);
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, error)) {
    fmt::print(stderr, "{}: error: the file cannot be read\n", file);
    return std::nullopt;
  }
  return ReadStream(stream);
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
  AddIcarusRecognise(*command, context);
  AddIcarusTranslate(*command, context);
}

}  // namespace latchwork::app
