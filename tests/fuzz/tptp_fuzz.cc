// SPDX-License-Identifier: BSD-3-Clause
// Any bytes: the reader gives formulas or diagnostics; what it gives can be written, reads back the
// same, and can be clausified, and the clauses read back too.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/clausify.h"
#include "latchwork/logic/tptp.h"

namespace latchwork::logic {
namespace {

void Require(bool holds, std::string_view what, const std::string& text) {
  if (holds) return;
  std::fprintf(stderr, "%.*s\n%s\n", static_cast<int>(what.size()), what.data(), text.c_str());
  std::abort();
}

std::vector<AnnotatedFormula> ReadBack(const std::string& text, SymbolTable& symbols) {
  TptpFile file = ReadTptp(text, "written.p", symbols);
  Require(file.diagnostics.empty(), "written text does not read back", Format(file.diagnostics));
  return std::move(file.formulas);
}

void CheckClauses(const std::vector<AnnotatedFormula>& formulas, SymbolTable& symbols) {
  ClausifyOptions options;
  options.max_symbols = 200'000;
  Diagnostics diagnostics;
  std::string text;
  for (const Clause& clause : Clausify(formulas, symbols, options, &diagnostics)) {
    text += WriteTptp(clause);
  }
  ReadBack(text, symbols);
}

void Try(std::string_view text) {
  SymbolTable symbols;
  const TptpFile file = ReadTptp(text, "fuzz.p", symbols);
  Require(Format(file.diagnostics).empty() == file.diagnostics.empty(), "silent diagnostics", "");
  ReadTptpAtom(text, "fuzz.xml", symbols);
  if (!file.diagnostics.empty()) return;
  const std::string written = WriteTptp(file.formulas);
  const auto again = ReadBack(written, symbols);
  Require(WriteTptp(again) == written, "written text reads back as another", written);
  CheckClauses(file.formulas, symbols);
}

}  // namespace
}  // namespace latchwork::logic

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  latchwork::logic::Try({reinterpret_cast<const char*>(data), size});
  return 0;
}
