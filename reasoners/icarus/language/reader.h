// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_READER_H_
#define LATCHWORK_ICARUS_READER_H_

#include <cstddef>
#include <string>

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/source_tree.h"

namespace latchwork::icarus {

/// Brackets may nest this deep.
inline constexpr std::size_t kMaxNesting = 1000;
/// Bytes of a program, and of what describes its world.
inline constexpr std::size_t kMaxProgramBytes = 16U << 20U;
inline constexpr std::size_t kMaxScriptBytes = 256U << 20U;

/// Reads the forms of a text. Never throws on bad input and does not recurse: each error is a
/// finding, and reading goes on at the next '(' that begins a line. What is left out of `roots` has
/// a finding. A text of more than `most` bytes, a whole number of MiB, is not read.
SourceTree ReadForms(std::string text, std::string file, Findings& findings,
                     std::size_t most = kMaxProgramBytes);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_READER_H_
