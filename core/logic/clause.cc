// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/clause.h"

#include "core/logic/print.h"

namespace latchwork::logic {

std::string ToString(const Literal& literal, std::span<const std::string> variable_names) {
  std::string text;
  AppendLiteral(text, literal.positive, literal.atom, variable_names);
  return text;
}

std::string ToString(const Clause& clause) {
  if (clause.literals.empty()) return "$false";
  std::string text;
  std::string_view separator;
  for (const Literal& literal : clause.literals) {
    text += separator;
    AppendLiteral(text, literal.positive, literal.atom, clause.variable_names);
    separator = " | ";
  }
  return text;
}

}  // namespace latchwork::logic
