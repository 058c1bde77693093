// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_READ_PROGRAM_FILE_H_
#define LATCHWORK_ICARUS_READ_PROGRAM_FILE_H_

#include <filesystem>

#include "latchwork/logic/diagnostic.h"
#include "reasoners/icarus/language/program_text.h"

namespace latchwork::icarus {

/// Adds a file to a program; that it cannot be read, and errors of syntax, are diagnostics.
void ReadProgramFile(const std::filesystem::path& file, ProgramText& text,
                     logic::Diagnostics& diagnostics);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_READ_PROGRAM_FILE_H_
