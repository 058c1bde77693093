// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_FORMATTER_H_
#define LATCHWORK_ICARUS_FORMATTER_H_

#include <string>

#include "reasoners/icarus/language/source_tree.h"

namespace latchwork::icarus {

/// The text of a program in its canonical layout: at most 100 columns where that can be, one slot
/// per line with what follows them aligned, comments kept where they belong, at most one blank line
/// between forms. Names keep their spelling. Formatting what is formatted changes nothing.
/// The tree must have been read without errors of syntax.
std::string FormatProgram(const SourceTree& tree);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_FORMATTER_H_
