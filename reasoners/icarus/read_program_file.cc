// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/read_program_file.h"

#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "reasoners/icarus/language/reader.h"

namespace latchwork::icarus {

void ReadProgramFile(const std::filesystem::path& file, ProgramText& text,
                     logic::Diagnostics& diagnostics) {
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, error)) {
    diagnostics.push_back({{file.string(), 0, 0}, "the file cannot be read", "", ""});
    return;
  }
  // One byte more than a program may have, so that the reader refuses what is larger.
  std::string read(kMaxProgramBytes + 1, '\0');
  stream.read(read.data(), static_cast<std::streamsize>(read.size()));
  read.resize(static_cast<std::size_t>(stream.gcount()));
  Findings findings;
  text.Add(std::move(read), file.string(), findings);
  for (logic::Diagnostic& each : ErrorsOf(findings)) diagnostics.push_back(std::move(each));
}

}  // namespace latchwork::icarus
