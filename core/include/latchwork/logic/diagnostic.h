// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_DIAGNOSTIC_H_
#define LATCHWORK_LOGIC_DIAGNOSTIC_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace latchwork::logic {

/// A place in a file that a person wrote. Lines and columns count from 1; 0 means "the file as a
/// whole". Columns count bytes.
struct SourcePlace {
  std::string file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

/// One thing that is wrong with an input: where, what, and, where it can be guessed, how to mend
/// it.
struct Diagnostic {
  SourcePlace place;
  std::string message;  ///< What is wrong, in one sentence without a full stop.
  std::string hint;     ///< How to mend it ("did you mean 'sonar'?"); may be empty.
  std::string excerpt;  ///< The line of the source at `place`, without its line end; may be empty.
};

using Diagnostics = std::vector<Diagnostic>;

/// Renders `file:line:column: error: message`, then the excerpt with a caret, then the hint. Ends
/// with a newline. Control characters of the excerpt are shown as '?', and long lines are cut
/// around the caret.
std::string Format(const Diagnostic& diagnostic);
/// With `label` ("warning", "note", "error[I004]") in place of "error".
std::string Format(const Diagnostic& diagnostic, std::string_view label);
std::string Format(const Diagnostics& diagnostics);

/// The candidate nearest to `word` by edit distance, or "" when none is near enough to be a typing
/// slip.
std::string_view NearestName(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_DIAGNOSTIC_H_
