// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/lexer.h"

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace latchwork::icarus {

namespace {

constexpr std::size_t kLongestAtom = 1024;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

bool EndsAtom(char c) {
  return IsBlank(c) || IsControl(c) || c == '(' || c == ')' || c == '{' || c == '}' || c == '"' ||
         c == ';';
}

std::size_t SkipDigits(std::string_view text, std::size_t at) {
  while (at < text.size() && IsDigit(text[at])) ++at;
  return at;
}

enum class Shape : std::uint8_t { kNone, kInteger, kReal };

/// [+-] digits [. digits] [e [+-] digits], with a digit before the exponent.
Shape ShapeOf(std::string_view text) {
  std::size_t at = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const std::size_t whole = SkipDigits(text, at);
  std::size_t digits = whole - at;
  at = whole;
  if (at == text.size()) return digits > 0 ? Shape::kInteger : Shape::kNone;
  if (text[at] == '.') {
    const std::size_t end = SkipDigits(text, at + 1);
    digits += end - at - 1;
    at = end;
  }
  if (digits == 0) return Shape::kNone;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
    const std::size_t end = SkipDigits(text, at);
    if (end == at) return Shape::kNone;
    at = end;
  }
  return at == text.size() ? Shape::kReal : Shape::kNone;
}

bool IsConstantName(std::string_view text) {
  return text.size() > 2 && text.front() == '*' && text.back() == '*';
}

}  // namespace

Lexer::Lexer(std::string_view text, std::vector<Comment>& comments)
    : text_(text), comments_(comments) {
  if (text_.starts_with(kByteOrderMark)) position_ = line_start_ = kByteOrderMark.size();
}

void Lexer::SkipComment() {
  std::size_t end = text_.find('\n', position_);
  if (end == std::string_view::npos) end = text_.size();
  std::size_t last = end;
  while (last > position_ && IsBlank(text_[last - 1])) --last;
  comments_.push_back(
      {static_cast<std::uint32_t>(position_), static_cast<std::uint32_t>(last), line_});
  position_ = end;
}

void Lexer::SkipBlanks() {
  while (position_ < text_.size()) {
    const char c = text_[position_];
    if (c == ';') {
      SkipComment();
    } else if (IsBlank(c)) {
      ++position_;
      if (c == '\n') {
        ++line_;
        line_start_ = position_;
      }
    } else {
      return;
    }
  }
}

Token Lexer::Take(Token::Kind kind, std::size_t length) {
  Token token;
  token.kind = kind;
  token.form.begin = static_cast<std::uint32_t>(position_);
  token.form.end = static_cast<std::uint32_t>(position_ + length);
  token.form.line = token.form.end_line = line_;
  token.form.column = static_cast<std::uint32_t>(position_ - line_start_ + 1);
  position_ += length;
  return token;
}

Token Lexer::Bad(std::size_t length, std::string problem, std::string remedy) {
  problem_ = std::move(problem);
  remedy_ = std::move(remedy);
  return Take(Token::Kind::kBad, length);
}

Token Lexer::Next() {
  SkipBlanks();
  if (position_ >= text_.size()) return Take(Token::Kind::kEnd, 0);
  const char c = text_[position_];
  if (c == '(' || c == '{' || c == ')' || c == '}') {
    Token token = Take(c == '(' || c == '{' ? Token::Kind::kOpen : Token::Kind::kClose, 1);
    token.bracket = c;
    return token;
  }
  if (c == '"') return String();
  if (IsControl(c)) return BadCharacter();
  return Atom();
}

Token Lexer::BadCharacter() {
  std::size_t length = 1;
  while (position_ + length < text_.size() && IsControl(text_[position_ + length]) &&
         !IsBlank(text_[position_ + length])) {
    ++length;
  }
  return Bad(length, "control characters have no place in a program", "take them out");
}

Token Lexer::TooLong(std::size_t length) {
  return Bad(length, "names and strings have at most " + std::to_string(kLongestAtom) + " bytes",
             "");
}

Token Lexer::String() {
  std::size_t end = position_ + 1;
  while (end < text_.size() && text_[end] != '"' && text_[end] != '\n') {
    end += At(end) == '\\' && end + 1 < text_.size() && text_[end + 1] != '\n' ? 2 : 1;
  }
  if (At(end) != '"') {
    std::size_t word = position_ + 1;
    while (word < end && !EndsAtom(text_[word])) ++word;
    return Bad(word - position_, "the string is not closed on its line", "add '\"'");
  }
  if (end - position_ > kLongestAtom) return TooLong(end + 1 - position_);
  Token token = Take(Token::Kind::kAtom, end + 1 - position_);
  token.form.kind = FormKind::kString;
  return token;
}

Token Lexer::Atom() {
  std::size_t end = position_;
  while (end < text_.size() && !EndsAtom(text_[end])) ++end;
  const std::size_t mark = text_.substr(position_, end - position_).find(kByteOrderMark);
  if (mark == 0) {
    return Bad(kByteOrderMark.size(), "a byte order mark may stand at the beginning of a file only",
               "take it out; most editors do not show it");
  }
  if (mark != std::string_view::npos) end = position_ + mark;
  if (end - position_ > kLongestAtom) return TooLong(end - position_);
  Token token = Take(Token::Kind::kAtom, end - position_);
  Classify(token);
  return token;
}

void Lexer::Classify(Token& token) {
  const std::string_view text = text_.substr(token.form.begin, token.form.end - token.form.begin);
  if (text[0] == '?') {
    token.form.kind = FormKind::kVariable;
  } else if (text[0] == ':') {
    token.form.kind = FormKind::kKeyword;
  } else if (IsConstantName(text)) {
    token.form.kind = FormKind::kConstant;
  } else {
    ClassifyNumber(token, text);
  }
}

void Lexer::ClassifyNumber(Token& token, std::string_view digits) {
  const Shape shape = ShapeOf(digits);
  token.form.kind = FormKind::kSymbol;
  if (shape == Shape::kNone) return;
  if (digits[0] == '+') digits.remove_prefix(1);
  const char* const end = digits.data() + digits.size();
  bool fits = false;
  if (shape == Shape::kInteger) {
    token.form.kind = FormKind::kInteger;
    fits = std::from_chars(digits.data(), end, token.form.integer).ec == std::errc();
  } else {
    token.form.kind = FormKind::kReal;
    double value = 0;
    fits = std::from_chars(digits.data(), end, value).ec == std::errc() && std::isfinite(value);
    token.form.real = value;
  }
  if (fits) return;
  token.kind = Token::Kind::kBad;
  problem_ = "the number does not fit";
  remedy_ = shape == Shape::kInteger ? "write it as a real, with a '.'" : "";
}

void Lexer::SkipToLineThatOpens(const Token& from) {
  position_ = from.form.begin;
  line_ = from.form.line;
  line_start_ = position_ + 1 - from.form.column;
  while (position_ < text_.size()) {
    if (position_ == line_start_ && text_[position_] == '(' && position_ > from.form.begin) break;
    ++position_;
    if (text_[position_ - 1] == '\n') {
      ++line_;
      line_start_ = position_;
    }
  }
  while (!comments_.empty() && comments_.back().begin >= position_) comments_.pop_back();
}

}  // namespace latchwork::icarus
