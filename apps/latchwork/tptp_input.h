// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_TPTP_INPUT_H_
#define LATCHWORK_APPS_LATCHWORK_TPTP_INPUT_H_

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <string>

#include "latchwork/logic/symbol.h"
#include "latchwork/logic/tptp.h"

namespace latchwork::app {

/// A TPTP file as the command line names it.
struct TptpInput {
  std::string file;    ///< "-": standard input.
  std::string folder;  ///< Where includes are looked for; empty: what the variable TPTP says.
  std::size_t max_tokens = logic::TptpOptions().max_tokens;
};

/// Adds `--tptp DIR`.
void AddTptpFolder(CLI::App& command, TptpInput& input);

/// What is wanted beside the formulas.
enum class Keep : std::uint8_t { kNothing, kSources, kTexts };

/// `text`: what has been read of a pipe or standard input already.
logic::TptpFile Read(const TptpInput& input, logic::SymbolTable& symbols,
                     Keep keep = Keep::kNothing, const std::string* text = nullptr);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_TPTP_INPUT_H_
