// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_NAME_WORDS_H_
#define LATCHWORK_ICARUS_NAME_WORDS_H_

#include <string>
#include <string_view>
#include <vector>

namespace latchwork::icarus {

/// The words of a name, folded: `no_echo`, `no-echo` and `NoEcho` are "no", "echo".
std::vector<std::string> WordsOf(std::string_view name);

/// Whether a name, as it is spelt, may be a slip for another that is near to it as a whole:
/// - the same words are one, in whatever style: `turn_left` for `TurnLeft`;
/// - else a slip keeps the first letter small or capital, so that facts in small letters are not
///   taken for skills with capitals: `hour` is no slip for `Pour`;
/// - and it strikes within words: `no_echo` is no slip for `note_echo`, as "no" is far from "note".
bool IsSlip(std::string_view written, std::string_view meant);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_NAME_WORDS_H_
