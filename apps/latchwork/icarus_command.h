// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_ICARUS_COMMAND_H_
#define LATCHWORK_APPS_LATCHWORK_ICARUS_COMMAND_H_

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "apps/latchwork/command.h"
#include "reasoners/icarus/language/program.h"

namespace latchwork::app {

/// The tools of `latchwork icarus`, one file each.
void AddIcarusCheck(CLI::App& icarus, Context& context);
void AddIcarusFormat(CLI::App& icarus, Context& context);
void AddIcarusRun(CLI::App& icarus, Context& context);
void AddIcarusTrace(CLI::App& icarus, Context& context);
void AddIcarusRepl(CLI::App& icarus, Context& context);
void AddIcarusLearn(CLI::App& icarus, Context& context);
void AddIcarusRecord(CLI::App& icarus, Context& context);
void AddIcarusRecognise(CLI::App& icarus, Context& context);
void AddIcarusTranslate(CLI::App& icarus, Context& context);

/// The text of a file, or of standard input for "-"; up to one byte more than a program may have,
/// so that the reader refuses what is larger. Nothing when it cannot be read, with a message on
/// standard error.
std::optional<std::string> ReadProgramText(const std::string& file);

/// Prints findings to standard error, and how many there are.
void PrintFindings(const std::string& file, const icarus::Findings& findings);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_ICARUS_COMMAND_H_
