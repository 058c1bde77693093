// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_LEXER_H_
#define LATCHWORK_ICARUS_LEXER_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/icarus/language/source_tree.h"

namespace latchwork::icarus {

struct Token {
  enum class Kind : std::uint8_t { kEnd, kOpen, kClose, kAtom, kBad };
  Kind kind = Kind::kEnd;
  char bracket = '\0';  ///< Of kOpen and kClose.
  Form form;            ///< Place and, of kAtom, kind and number.
};

/// Cuts a text into brackets and atoms; keeps the comments. The text must outlive it.
class Lexer {
 public:
  Lexer(std::string_view text, std::vector<Comment>& comments);

  Token Next();
  /// Of the last token, when it was kBad.
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }
  /// Goes on, at or after the end of this token, at the next '(' that begins a line; forgets the
  /// comments from there on.
  void SkipToLineThatOpens(const Token& from);

 private:
  char At(std::size_t position) const { return position < text_.size() ? text_[position] : '\0'; }
  void SkipBlanks();
  void SkipComment();
  Token Take(Token::Kind kind, std::size_t length);
  Token Bad(std::size_t length, std::string problem, std::string remedy);
  Token BadCharacter();
  Token TooLong(std::size_t length);
  Token String();
  Token Atom();
  void Classify(Token& token);
  void ClassifyNumber(Token& token, std::string_view digits);

  std::string_view text_;
  std::vector<Comment>& comments_;
  std::size_t position_ = 0;
  std::size_t line_start_ = 0;
  std::uint32_t line_ = 1;
  std::string problem_;
  std::string remedy_;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_LEXER_H_
