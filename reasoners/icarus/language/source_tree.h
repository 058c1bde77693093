// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_SOURCE_TREE_H_
#define LATCHWORK_ICARUS_SOURCE_TREE_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::icarus {

/// What a form of the source is: a list in parentheses, a call in braces, or one of the atoms.
enum class FormKind : std::uint8_t {
  kList,
  kCall,
  kVariable,
  kKeyword,
  kConstant,
  kInteger,
  kReal,
  kString,
  kSymbol,
};

using FormId = std::uint32_t;
inline constexpr FormId kNoForm = std::numeric_limits<FormId>::max();

/// One form and where it stands. `begin` and `end` are byte offsets into the text; lines and
/// columns count from 1, columns in bytes.
struct Form {
  FormKind kind = FormKind::kSymbol;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  std::uint32_t end_line = 1;
  FormId first_child = kNoForm;
  FormId next_sibling = kNoForm;
  std::int64_t integer = 0;  ///< kInteger.
  double real = 0;           ///< kReal.
};

/// `; …` up to the end of its line.
struct Comment {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t line = 1;
};

/// Where, in a text that was put together from several, one of them begins.
struct SourcePart {
  std::uint32_t first_line = 1;
  std::string file;
};

/// A file as it was written: the forms as a flat tree, and the comments in order.
struct SourceTree {
  std::string file;
  std::vector<SourcePart> parts;  ///< By their first lines; none: all is of `file`.
  std::string text;
  std::vector<Form> forms;
  std::vector<FormId> roots;
  std::vector<Comment> comments;

  const Form& at(FormId id) const { return forms[id]; }
  FormKind kind(FormId id) const { return forms[id].kind; }
  /// As written.
  std::string_view Text(FormId id) const;
  std::string_view Text(const Comment& comment) const;
  /// The name of an atom with its letters folded: names do not depend on case.
  std::string Folded(FormId id) const;
  /// What a string stands for: without quotes and escapes.
  std::string Unquoted(FormId id) const;
  std::vector<FormId> Children(FormId id) const;
  /// Whether a form of the top level is `(top (Skill ...))`; skills may have that name, too.
  bool IsTop(FormId root) const;
  /// Whether a form of the top level is `(never clause ...)`; skills may have that name, too.
  bool IsNever(FormId root) const;
  logic::SourcePlace Place(FormId id) const;
  /// Of a line of the whole text.
  logic::SourcePlace PlaceAt(std::uint32_t line, std::uint32_t column) const;
  /// The line that holds this offset, without its end; empty when it is too long to be shown.
  std::string_view LineAt(std::size_t offset) const;
};

/// ASCII letters in lower case; everything else as it is.
std::string Fold(std::string_view name);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_SOURCE_TREE_H_
