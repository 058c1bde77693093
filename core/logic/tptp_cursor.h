// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_TPTP_CURSOR_H_
#define LATCHWORK_LOGIC_TPTP_CURSOR_H_

#include <cstddef>
#include <string>
#include <string_view>

#include "core/logic/tptp_lexer.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::logic {

/// The token that a parser looks at, and the voice in which it complains about it.
class TptpCursor {
 public:
  TptpCursor(std::string_view text, std::string_view file, std::size_t max_tokens,
             Diagnostics& diagnostics);

  const TptpToken& token() const { return token_; }
  TptpToken::Kind kind() const { return token_.kind; }
  bool Is(TptpToken::Kind kind) const { return token_.kind == kind; }
  void Advance();
  /// Consumes a token of this kind; false when the present one is another.
  bool Accept(TptpToken::Kind kind);
  /// The same; another token is a diagnostic.
  bool Expect(TptpToken::Kind kind, std::string_view what, std::string_view hint = {});
  /// Reports a fault at the present token; false.
  bool Fail(std::string message, std::string hint = {});
  /// Reports that something else should be here; adds what is known about the present token; false.
  bool FailExpected(std::string_view what, std::string_view hint = {});
  /// Reports a fault at a place before the present token; false.
  bool FailAt(SourcePlace place, std::string message, std::string hint = {});

  SourcePlace place() const { return {file_, token_.line, token_.column}; }
  /// The present token as a message names it: `'=>'`, "the end of the file".
  std::string Found() const;

 private:
  TptpLexer lexer_;
  TptpToken token_;
  std::string file_;
  std::size_t tokens_left_;
  Diagnostics& diagnostics_;
};

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_TPTP_CURSOR_H_
