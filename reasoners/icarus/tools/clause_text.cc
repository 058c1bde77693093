// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/tools/clause_text.h"

#include <algorithm>

namespace latchwork::icarus {

namespace {

void Append(const SourceTree& source, FormId form, const VariableValues& variables,
            const NamePool& names, std::string& text) {
  const Form& at = source.at(form);
  if (at.kind == FormKind::kList || at.kind == FormKind::kCall) {
    text += at.kind == FormKind::kList ? '(' : '{';
    for (FormId child = at.first_child; child != kNoForm; child = source.at(child).next_sibling) {
      if (child != at.first_child) text += ' ';
      Append(source, child, variables, names, text);
    }
    text += at.kind == FormKind::kList ? ')' : '}';
    return;
  }
  if (at.kind == FormKind::kVariable) {
    const auto found =
        std::find(variables.names.begin(), variables.names.end(), source.Folded(form));
    const auto index = static_cast<std::size_t>(found - variables.names.begin());
    if (index < variables.values.size() && !variables.values[index].is_none()) {
      text += ToString(variables.values[index], names);
      return;
    }
  }
  text += source.Text(form);
}

}  // namespace

std::string ClauseText(const SourceTree& source, FormId form, const VariableValues& variables,
                       const NamePool& names) {
  std::string text;
  if (form != kNoForm) Append(source, form, variables, names, text);
  return text;
}

std::string CallText(std::string_view function, std::span<const Value> arguments,
                     const NamePool& names) {
  std::string text = "{" + std::string(function);
  for (const Value& argument : arguments) text += ' ' + ToString(argument, names);
  return text + '}';
}

}  // namespace latchwork::icarus
