// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_CLAUSE_TEXT_H_
#define LATCHWORK_ICARUS_CLAUSE_TEXT_H_

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "reasoners/icarus/language/source_tree.h"
#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// The variables of a skill, or of a top call, and what they are bound to; none: unbound.
struct VariableValues {
  std::span<const std::string> names;  ///< Folded, with '?'.
  std::span<const Value> values;
};

/// A form as it is written, on one line, with its variables replaced by what they are bound to.
std::string ClauseText(const SourceTree& source, FormId form, const VariableValues& variables,
                       const NamePool& names);

/// {function argument ...}
std::string CallText(std::string_view function, std::span<const Value> arguments,
                     const NamePool& names);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_CLAUSE_TEXT_H_
