// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/reader.h"

#include <utility>
#include <vector>

#include "reasoners/icarus/language/lexer.h"

namespace latchwork::icarus {

namespace {

class Reader {
 public:
  Reader(SourceTree& tree, Findings& findings)
      : tree_(tree), lexer_(tree.text, tree.comments), reporter_(tree, findings) {}

  void ReadAll() {
    for (Token token = lexer_.Next(); token.kind != Token::Kind::kEnd && !reporter_.full();
         token = lexer_.Next()) {
      switch (token.kind) {
        case Token::Kind::kOpen:
          ReadRoot(token);
          break;
        case Token::Kind::kClose:
          Complain(Code::kBracket, token,
                   std::string("this '") + token.bracket + "' closes nothing", "take it out");
          break;
        case Token::Kind::kAtom:
          tree_.roots.push_back(Append(token.form));
          break;
        default:
          Complain(Code::kToken, token, lexer_.problem(), lexer_.remedy());
      }
    }
  }

 private:
  struct Open {
    FormId form;
    FormId last_child;
  };

  void Complain(Code code, const Token& at, std::string message, std::string hint = {}) {
    reporter_.AddAt(code, at.form.begin, at.form.line, at.form.column, std::move(message),
                    std::move(hint));
  }

  FormId Append(const Form& form) {
    const auto id = static_cast<FormId>(tree_.forms.size());
    tree_.forms.push_back(form);
    if (open_.empty()) return id;
    Open& parent = open_.back();
    FormId& link = parent.last_child == kNoForm ? tree_.forms[parent.form].first_child
                                                : tree_.forms[parent.last_child].next_sibling;
    link = id;
    parent.last_child = id;
    return id;
  }

  void Push(const Token& token) {
    Form form = token.form;
    form.kind = token.bracket == '(' ? FormKind::kList : FormKind::kCall;
    open_.push_back({Append(form), kNoForm});
  }

  /// Reads up to the bracket that closes `first`; a form with a mistake in its brackets is dropped.
  void ReadRoot(const Token& first) {
    open_.clear();
    Push(first);
    const FormId root = open_.back().form;
    while (!open_.empty()) {
      const Token token = lexer_.Next();
      if (token.kind == Token::Kind::kOpen && open_.size() < kMaxNesting) {
        Push(token);
      } else if (token.kind == Token::Kind::kAtom) {
        Append(token.form);
      } else if (token.kind == Token::Kind::kBad) {
        Complain(Code::kToken, token, lexer_.problem(), lexer_.remedy());
      } else if (!Close(first, token)) {
        open_.clear();
        return;
      }
    }
    tree_.roots.push_back(root);
  }

  bool Close(const Token& first, const Token& token) {
    if (token.kind == Token::Kind::kOpen) {
      Complain(Code::kDepth, token, "brackets nest deeper than " + std::to_string(kMaxNesting));
      lexer_.SkipToLineThatOpens(token);
      return false;
    }
    const FormId open = open_.back().form;
    const bool list = tree_.kind(open) == FormKind::kList;
    const char wanted = list ? ')' : '}';
    if (token.kind == Token::Kind::kClose && token.bracket == wanted) {
      tree_.forms[open].end = token.form.end;
      tree_.forms[open].end_line = token.form.line;
      open_.pop_back();
      return true;
    }
    if (token.kind == Token::Kind::kEnd) {
      Unclosed(first, open);
    } else {
      Mismatch(token, open, wanted);
    }
    return false;
  }

  void Mismatch(const Token& token, FormId open, char wanted) {
    const Form& opener = tree_.at(open);
    Complain(Code::kBracket, token,
             std::string("expected '") + wanted + "' to close '" + tree_.text[opener.begin] +
                 "' of " + std::to_string(opener.line) + ':' + std::to_string(opener.column));
    reporter_.Note(open, "opened here");
    lexer_.SkipToLineThatOpens(token);
  }

  void Unclosed(const Token& first, FormId innermost) {
    lexer_.SkipToLineThatOpens(first);
    Complain(Code::kBracket, first, "this '(' is not closed before the end of the file",
             "count the brackets of this form");
    if (innermost != open_.front().form) {
      reporter_.Note(innermost, "the last bracket left open");
    }
  }

  SourceTree& tree_;
  Lexer lexer_;
  Reporter reporter_;
  std::vector<Open> open_;
};

/// Bytes of the UTF-8 character at `at`; 0 where there is none.
std::size_t CharacterLength(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned lead = byte(at);
  const std::size_t length = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  if (length > 1 && (lead < 0xc2 || lead > 0xf4)) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0U) != 0x80) return 0;
  }
  const unsigned next = byte(at + 1);
  const bool overlong = (lead == 0xe0 && next < 0xa0) || (lead == 0xf0 && next < 0x90);
  const bool outside = (lead == 0xed && next > 0x9f) || (lead == 0xf4 && next > 0x8f);
  return overlong || outside ? 0 : length;
}

bool IsText(const SourceTree& tree, Findings& findings) {
  std::size_t line_start = 0;
  std::uint32_t line = 1;
  for (std::size_t at = 0; at < tree.text.size();) {
    const std::size_t length = CharacterLength(tree.text, at);
    if (length == 0) {
      Reporter(tree, findings)
          .AddAt(Code::kToken, static_cast<std::uint32_t>(at), line,
                 static_cast<std::uint32_t>(at - line_start + 1), "this byte is no UTF-8",
                 "save the file as UTF-8");
      return false;
    }
    at += length;
    if (tree.text[at - 1] != '\n') continue;
    ++line;
    line_start = at;
  }
  return true;
}

}  // namespace

SourceTree ReadForms(std::string text, std::string file, Findings& findings, std::size_t most) {
  SourceTree tree;
  tree.file = std::move(file);
  if (text.size() > most) {
    Reporter(tree, findings)
        .AddAt(Code::kToken, 0, 0, 0,
               "the file is larger than it may be (" + std::to_string(most >> 20U) + " MiB)");
    return tree;
  }
  tree.text = std::move(text);
  if (IsText(tree, findings)) Reader(tree, findings).ReadAll();
  return tree;
}

}  // namespace latchwork::icarus
