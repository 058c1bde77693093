// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/tptp_lexer.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/logic/utf8.h"

namespace latchwork::logic {

namespace {

using Kind = TptpToken::Kind;

constexpr std::size_t kLongestLineShown = 4096;

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLower(char c) { return c >= 'a' && c <= 'z'; }
bool IsUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool IsWordByte(char c) { return IsLower(c) || IsUpper(c) || IsDigit(c) || c == '_'; }

struct Spelling {
  std::string_view text;
  Kind kind;
};

/// The first that fits is taken, so longer ones come before their beginnings.
constexpr std::array kSpellings = {
    Spelling{"(", Kind::kLeftParenthesis},
    Spelling{")", Kind::kRightParenthesis},
    Spelling{"[", Kind::kLeftBracket},
    Spelling{"]", Kind::kRightBracket},
    Spelling{",", Kind::kComma},
    Spelling{".", Kind::kDot},
    Spelling{"<=>", Kind::kEquivalent},
    Spelling{"<~>", Kind::kXor},
    Spelling{"<->", Kind::kOther},
    Spelling{"<==>", Kind::kOther},
    Spelling{"-->", Kind::kOther},
    Spelling{"==>", Kind::kOther},
    Spelling{"=>", Kind::kImplies},
    Spelling{"<=", Kind::kImpliedBy},
    Spelling{"<-", Kind::kOther},
    Spelling{"->", Kind::kOther},
    Spelling{"~|", Kind::kNor},
    Spelling{"~&", Kind::kNand},
    Spelling{"&&", Kind::kOther},
    Spelling{"||", Kind::kOther},
    Spelling{"!=", Kind::kNotEqual},
    Spelling{"==", Kind::kOther},
    Spelling{"\\=", Kind::kOther},
    Spelling{"\\+", Kind::kOther},
    Spelling{":=", Kind::kOther},
    Spelling{":-", Kind::kOther},
    Spelling{":", Kind::kColon},
    Spelling{"-", Kind::kMinus},
    Spelling{"*", Kind::kStar},
    Spelling{"~", Kind::kNot},
    Spelling{"&", Kind::kAnd},
    Spelling{"|", Kind::kOr},
    Spelling{"=", Kind::kEqual},
    Spelling{"!", Kind::kForall},
    Spelling{"?", Kind::kExists},
};

}  // namespace

std::string_view TptpLexer::Line(std::size_t lines_before) const {
  std::size_t start = token_line_start_;
  for (; lines_before > 0 && start > 0; --lines_before) {
    const std::size_t end = start >= 2 ? text_.rfind('\n', start - 2) : std::string_view::npos;
    start = end == std::string_view::npos ? 0 : end + 1;
  }
  const std::string_view rest = text_.substr(start, kLongestLineShown);
  const std::size_t end = rest.find_first_of("\r\n");
  if (end == std::string_view::npos && rest.size() == kLongestLineShown) return {};
  return rest.substr(0, end);
}

void TptpLexer::NewLine(std::size_t start) {
  ++line_;
  line_start_ = start;
}

void TptpLexer::SkipLineComment() {
  position_ = std::min(text_.find('\n', position_), text_.size());
}

bool TptpLexer::SkipBlockComment() {
  const std::size_t end = text_.find("*/", position_ + 2);
  if (end == std::string_view::npos) return false;
  for (std::size_t at = text_.find('\n', position_); at < end; at = text_.find('\n', at + 1)) {
    NewLine(at + 1);
  }
  position_ = end + 2;
  return true;
}

bool TptpLexer::SkipBlanks() {
  while (!AtEnd()) {
    const char c = text_[position_];
    if (c == '\n') {
      NewLine(++position_);
    } else if (c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v') {
      ++position_;
    } else if (c == '%') {
      SkipLineComment();
    } else if (c == '/' && At(1) == '*') {
      if (!SkipBlockComment()) return false;
    } else {
      return true;
    }
  }
  return true;
}

TptpToken TptpLexer::Take(Kind kind, std::size_t length) {
  TptpToken token;
  token.kind = kind;
  token.text = text_.substr(position_, length);
  token.line = line_;
  token.column = static_cast<std::uint32_t>(position_ - line_start_ + 1);
  token.first_on_line = line_ != last_token_line_;
  last_token_line_ = line_;
  token_line_start_ = line_start_;
  position_ += token.text.size();
  return token;
}

TptpToken TptpLexer::Bad(std::size_t length, std::string problem, std::string remedy) {
  problem_ = std::move(problem);
  remedy_ = std::move(remedy);
  return Take(Kind::kBad, length);
}

TptpToken TptpLexer::Next() {
  if (!SkipBlanks()) {
    return Bad(std::string_view::npos, "comment is not closed", "end it with '*/'");
  }
  if (AtEnd()) return Take(Kind::kEnd, 0);
  const char c = text_[position_];
  if (IsLower(c)) return Word(Kind::kLowerWord);
  if (IsUpper(c) || c == '_') return Word(Kind::kUpperWord);
  if (c == '$') return Word(Kind::kDollarWord);
  if (c == '\'') return Quoted(c, Kind::kQuoted);
  if (c == '"') return Quoted(c, Kind::kDistinctObject);
  if (IsDigit(c) || ((c == '-' || c == '+') && IsDigit(At(1)))) return Number();
  return Symbol();
}

TptpToken TptpLexer::Word(Kind kind) {
  std::size_t length = 1;
  if (kind == Kind::kDollarWord) {
    if (At(1) == '$') ++length;
    if (!IsLower(At(length))) {
      return Bad(length, "a lower-case word must follow '$'", "");
    }
  }
  while (IsWordByte(At(length))) ++length;
  return Take(kind, length);
}

TptpToken TptpLexer::Quoted(char quote, Kind kind) {
  std::size_t length = 1;
  while (true) {
    const char c = At(length);
    if (position_ + length >= text_.size() || c == '\n') {
      return Bad(length, "quote is not closed on its line", std::string("end it with ") + quote);
    }
    if (c == quote) break;
    if (c == '\\' && At(length + 1) != quote && At(length + 1) != '\\') {
      return Bad(length + 1, "only a quote or a backslash may follow a backslash",
                 "write '\\\\' for a backslash");
    }
    if (c == '\\') ++length;
    const std::size_t bytes = Utf8Length(text_.substr(position_ + length, 4));
    if (bytes == 0) return Bad(length + 1, "quoted text is not UTF-8", "");
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      return Bad(length + 1, "control character in quoted text", "");
    }
    length += bytes;
  }
  if (length == 1 && kind == Kind::kQuoted) return Bad(2, "a quoted word must not be empty", "");
  return Take(kind, length + 1);
}

std::size_t TptpLexer::Digits(std::size_t offset) const {
  while (IsDigit(At(offset))) ++offset;
  return offset;
}

/// The offset behind an exponent that begins at `offset`; `offset` when there is none.
std::size_t TptpLexer::Exponent(std::size_t offset) const {
  if (At(offset) != 'e' && At(offset) != 'E') return offset;
  const std::size_t digits = offset + (At(offset + 1) == '+' || At(offset + 1) == '-' ? 2 : 1);
  return IsDigit(At(digits)) ? Digits(digits) : offset;
}

TptpToken TptpLexer::Number() {
  const std::size_t whole = Digits(1);
  if (At(whole) == '/' && IsDigit(At(whole + 1))) return Take(Kind::kRational, Digits(whole + 1));
  const std::size_t fraction =
      At(whole) == '.' && IsDigit(At(whole + 1)) ? Digits(whole + 1) : whole;
  const std::size_t end = Exponent(fraction);
  return Take(end == whole ? Kind::kInteger : Kind::kReal, end);
}

TptpToken TptpLexer::Symbol() {
  for (const auto& [text, kind] : kSpellings) {
    if (text[0] != text_[position_] || !Starts(text)) continue;
    // `! [X] :-1 < X`: a colon and a number.
    if (text == ":-" && IsDigit(At(2))) continue;
    return Take(kind, text.size());
  }
  const char c = text_[position_];
  if (c > 0x20 && c < 0x7f) return Take(Kind::kOther, 1);
  const std::size_t bytes = Utf8Length(text_.substr(position_, 4));
  if (bytes > 1) {
    return Bad(bytes, "only quoted words may hold characters beyond ASCII",
               "put the word in single quotes");
  }
  return Bad(1, "byte that no TPTP text may hold", "");
}

std::string Unquote(std::string_view quoted) {
  std::string text;
  quoted = quoted.substr(1, quoted.size() - 2);
  for (std::size_t i = 0; i < quoted.size(); ++i) {
    if (quoted[i] == '\\') ++i;
    text += quoted[i];
  }
  return text;
}

}  // namespace latchwork::logic
