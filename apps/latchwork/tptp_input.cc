// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/tptp_input.h"

#include <cstdlib>
#include <filesystem>
#include <string>

#include "apps/latchwork/input_text.h"

namespace latchwork::app {
namespace {

/// Whether its includes are looked for in a folder of its own.
bool IsInFolder(const std::string& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  return !std::filesystem::exists(status) || std::filesystem::is_directory(status) ||
         std::filesystem::is_regular_file(status);
}

}  // namespace

void AddTptpFolder(CLI::App& command, TptpInput& input) {
  command.add_option("--tptp", input.folder,
                     "Folder that includes are looked for in, after the folder of the file; "
                     "without it, what the environment variable TPTP names");
}

logic::TptpFile Read(const TptpInput& input, logic::SymbolTable& symbols, Keep keep,
                     const std::string* text) {
  logic::TptpOptions options;
  options.keep_sources = keep == Keep::kSources;
  options.keep_texts = keep == Keep::kTexts;
  options.max_tokens = input.max_tokens;
  options.include_root = input.folder;
  const char* const root = std::getenv("TPTP");
  if (input.folder.empty() && root != nullptr) options.include_root = root;
  if (input.file != "-" && IsInFolder(input.file)) {
    return logic::ReadTptpFile(input.file, symbols, options);
  }
  if (text != nullptr) return logic::ReadTptp(*text, input.file, symbols, options);
  logic::TptpFile none;
  const auto read = ReadInputText(input.file, none.diagnostics);
  return read ? logic::ReadTptp(*read, input.file, symbols, options) : none;
}

}  // namespace latchwork::app
