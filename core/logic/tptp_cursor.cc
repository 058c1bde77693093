// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/tptp_cursor.h"

#include <array>
#include <utility>

namespace latchwork::logic {

namespace {

using Kind = TptpToken::Kind;

constexpr std::size_t kLongestTokenShown = 40;

/// What people write who think of another language, and what TPTP says instead.
constexpr std::array<std::pair<std::string_view, std::string_view>, 13> kForeign = {{
    {":-", "':-' is Prolog; write 'conclusion <= premise', or 'conclusion | ~ premise' in cnf"},
    {"->", "TPTP writes implication as '=>'"},
    {"-->", "TPTP writes implication as '=>'"},
    {"==>", "TPTP writes implication as '=>'"},
    {"<-", "TPTP writes the reverse implication as '<='"},
    {"<->", "TPTP writes equivalence as '<=>'"},
    {"<==>", "TPTP writes equivalence as '<=>'"},
    {"&&", "TPTP writes conjunction as '&'"},
    {"||", "TPTP writes disjunction as '|'"},
    {"==", "TPTP writes equality as '='"},
    {"\\=", "TPTP writes inequality as '!='"},
    {"\\+", "TPTP writes negation as '~'"},
    {"@", "'@' is higher-order; write p(X)"},
}};

std::string_view Remedy(std::string_view token) {
  for (const auto& [text, remedy] : kForeign) {
    if (text == token) return remedy;
  }
  return {};
}

}  // namespace

TptpCursor::TptpCursor(std::string_view text, std::string_view file, std::size_t max_tokens,
                       Diagnostics& diagnostics)
    : lexer_(text), file_(file), tokens_left_(max_tokens), diagnostics_(diagnostics) {
  token_ = lexer_.Next();
}

void TptpCursor::Advance() {
  if (tokens_left_ > 0) {
    --tokens_left_;
    token_ = lexer_.Next();
    return;
  }
  if (Is(Kind::kEnd)) return;
  Fail("text is too long: it has more tokens than may be read at once");
  token_.kind = Kind::kEnd;
  token_.text = {};
}

bool TptpCursor::Accept(Kind kind) {
  if (!Is(kind)) return false;
  Advance();
  return true;
}

bool TptpCursor::Expect(Kind kind, std::string_view what, std::string_view hint) {
  return Accept(kind) || FailExpected(what, hint);
}

bool TptpCursor::Fail(std::string message, std::string hint) {
  if (Is(Kind::kBad)) {
    message = lexer_.problem();
    hint = lexer_.remedy();
  }
  diagnostics_.push_back(
      {place(), std::move(message), std::move(hint), std::string(lexer_.Line())});
  return false;
}

bool TptpCursor::FailExpected(std::string_view what, std::string_view hint) {
  const std::string_view remedy = Remedy(token_.text);
  return Fail("expected " + std::string(what) + ", found " + Found(),
              std::string(remedy.empty() ? hint : remedy));
}

bool TptpCursor::FailAt(SourcePlace place, std::string message, std::string hint) {
  std::string line(lexer_.Line(token_.line - place.line));
  diagnostics_.push_back({std::move(place), std::move(message), std::move(hint), std::move(line)});
  return false;
}

std::string TptpCursor::Found() const {
  if (Is(Kind::kEnd)) return "the end of the text";
  if (token_.text.size() > kLongestTokenShown) {
    return '\'' + std::string(token_.text.substr(0, kLongestTokenShown)) + "...'";
  }
  return '\'' + std::string(token_.text) + '\'';
}

}  // namespace latchwork::logic
