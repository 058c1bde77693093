// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/tptp_input.h"

#include <array>
#include <cstdlib>
#include <iostream>

namespace latchwork::app {
namespace {

/// Standard input up to one byte more than may be read, so that the reader refuses what is larger.
std::string ReadStandardInput(std::size_t max_bytes) {
  std::string text;
  std::array<char, 1U << 16U> buffer{};
  while (text.size() <= max_bytes) {
    std::cin.read(buffer.data(), buffer.size());
    if (std::cin.gcount() == 0) break;
    text.append(buffer.data(), static_cast<std::size_t>(std::cin.gcount()));
  }
  return text;
}

}  // namespace

void AddTptpFolder(CLI::App& command, TptpInput& input) {
  command.add_option("--tptp", input.folder,
                     "Folder that includes are looked for in, after the folder of the file; "
                     "without it, what the environment variable TPTP names");
}

logic::TptpFile Read(const TptpInput& input, logic::SymbolTable& symbols, Keep keep) {
  logic::TptpOptions options;
  options.keep_sources = keep == Keep::kSources;
  options.keep_texts = keep == Keep::kTexts;
  options.max_tokens = input.max_tokens;
  options.include_root = input.folder;
  const char* const root = std::getenv("TPTP");
  if (input.folder.empty() && root != nullptr) options.include_root = root;
  if (input.file != "-") return logic::ReadTptpFile(input.file, symbols, options);
  return logic::ReadTptp(ReadStandardInput(options.max_bytes), "-", symbols, options);
}

}  // namespace latchwork::app
