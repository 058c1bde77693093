// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as an Icarus program: it is read, checked, and, where its brackets and atoms are right,
// formatted. What is formatted has the same atoms in the same order, and formatting it again
// changes nothing.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/language/reader.h"
#include "reasoners/icarus/tools/formatter.h"

namespace latchwork::icarus {
namespace {

void Require(bool holds, std::string_view what, const std::string& text) {
  if (holds) return;
  std::fprintf(stderr, "%.*s\n%s\n", static_cast<int>(what.size()), what.data(), text.c_str());
  std::abort();
}

/// Brackets and atoms, one after the other.
std::vector<std::string> Tokens(const SourceTree& tree) {
  std::vector<std::pair<std::uint32_t, std::string>> tokens;
  for (FormId id = 0; id < tree.forms.size(); ++id) {
    const Form& form = tree.at(id);
    const bool list = form.kind == FormKind::kList;
    if (list || form.kind == FormKind::kCall) {
      tokens.emplace_back(form.begin, list ? "(" : "{");
      tokens.emplace_back(form.end - 1, list ? ")" : "}");
    } else {
      tokens.emplace_back(form.begin, tree.Text(id));
    }
  }
  std::sort(tokens.begin(), tokens.end());
  std::vector<std::string> texts;
  for (auto& token : tokens) texts.push_back(std::move(token.second));
  return texts;
}

void CheckFormatter(const std::string& text) {
  Findings findings;
  const SourceTree tree = ReadForms(text, "fuzz.icarus", findings);
  if (HasErrors(findings)) return;
  const std::string formatted = FormatProgram(tree);
  const SourceTree again = ReadForms(formatted, "formatted.icarus", findings);
  Require(!HasErrors(findings), "formatted text does not read back", formatted);
  Require(Tokens(tree) == Tokens(again), "formatting changed the program", formatted);
  Require(tree.comments.size() == again.comments.size(), "formatting lost a comment", formatted);
  Require(FormatProgram(again) == formatted, "formatting twice is not formatting once", formatted);
}

void Try(const std::string& text) {
  for (const bool strict : {false, true}) {
    const ProgramFile file = ReadProgram(text, "fuzz.icarus", {strict, "top"});
    for (const Finding& finding : file.findings) {
      Require(!Format(finding).empty(), "silent finding", text);
    }
  }
  CheckFormatter(text);
}

}  // namespace
}  // namespace latchwork::icarus

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  latchwork::icarus::Try({reinterpret_cast<const char*>(data), size});
  return 0;
}
