// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/tptp_input.h"

#include <cstdlib>
#include <string>

#include "apps/latchwork/input_text.h"

namespace latchwork::app {
namespace {

logic::TptpFile Unreadable() {
  logic::TptpFile file;
  file.diagnostics.push_back({{"-", 0, 0}, std::string(kInputUnreadable), "", ""});
  return file;
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
  const auto text = ReadStandardInput(options.max_bytes);
  return text ? logic::ReadTptp(*text, "-", symbols, options) : Unreadable();
}

}  // namespace latchwork::app
