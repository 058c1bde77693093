// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_TPTP_LEXER_H_
#define LATCHWORK_LOGIC_TPTP_LEXER_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace latchwork::logic {

struct TptpToken {
  enum class Kind : std::uint8_t {
    kEnd,
    kBad,  ///< No token of TPTP; the lexer says why.
    kLowerWord,
    kUpperWord,
    kDollarWord,
    kQuoted,
    kDistinctObject,
    kInteger,
    kRational,
    kReal,
    kLeftParenthesis,
    kRightParenthesis,
    kLeftBracket,
    kRightBracket,
    kComma,
    kDot,
    kColon,
    kMinus,
    kStar,
    kNot,
    kAnd,
    kOr,
    kImplies,
    kImpliedBy,
    kEquivalent,
    kXor,
    kNor,
    kNand,
    kEqual,
    kNotEqual,
    kForall,
    kExists,
    kOther,  ///< What TPTP knows elsewhere, or other languages: `@`, `:-`, `->`.
  };

  Kind kind = Kind::kEnd;
  std::string_view text;  ///< As written, quotes included.
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  bool first_on_line = true;
};

/// Cuts a TPTP text into tokens; skips blanks and comments. The text must outlive the tokens.
class TptpLexer {
 public:
  explicit TptpLexer(std::string_view text) : text_(text) {}

  TptpToken Next();
  /// Of the last token, when it was kBad.
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }
  /// The line that the last token begins on, or one before it; empty when too long to be shown.
  std::string_view Line(std::size_t lines_before = 0) const;

 private:
  char At(std::size_t offset) const {
    return position_ + offset < text_.size() ? text_[position_ + offset] : '\0';
  }
  bool Starts(std::string_view with) const {
    return text_.substr(position_).substr(0, with.size()) == with;
  }
  bool AtEnd() const { return position_ >= text_.size(); }
  void NewLine(std::size_t start);
  void SkipLineComment();
  bool SkipBlockComment();
  /// Nothing left to skip: true. An unclosed comment: false.
  bool SkipBlanks();
  TptpToken Take(TptpToken::Kind kind, std::size_t length);
  TptpToken Bad(std::size_t length, std::string problem, std::string remedy);
  TptpToken Quoted(char quote, TptpToken::Kind kind);
  TptpToken Number();
  TptpToken Word(TptpToken::Kind kind);
  TptpToken Symbol();
  std::size_t Digits(std::size_t offset) const;
  std::size_t Exponent(std::size_t offset) const;

  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_start_ = 0;
  std::size_t token_line_start_ = 0;
  std::uint32_t line_ = 1;
  std::uint32_t last_token_line_ = 0;
  std::string problem_;
  std::string remedy_;
};

/// What a quoted word or distinct object stands for: without quotes and escapes.
std::string Unquote(std::string_view quoted);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_TPTP_LEXER_H_
