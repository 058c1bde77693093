// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/print.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/logic/tptp.h"

namespace latchwork::logic {

namespace {

bool IsWordByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// A lower word, or one or two dollars and a lower word.
bool IsBareWord(std::string_view name) {
  name.remove_prefix(std::min(name.find_first_not_of('$'), std::min<std::size_t>(name.size(), 2)));
  return !name.empty() && name[0] >= 'a' && name[0] <= 'z' &&
         std::all_of(name.begin(), name.end(), IsWordByte);
}

void AppendQuoted(std::string& text, std::string_view name, char quote) {
  text += quote;
  for (const char c : name) {
    if (c == quote || c == '\\') text += '\\';
    text += c;
  }
  text += quote;
}

template <typename Number>
std::string_view Print(Number number, std::array<char, 32>& buffer) {
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return {buffer.data(), static_cast<std::size_t>(end - buffer.data())};
}

void AppendNumber(std::string& text, const Term& term) {
  std::array<char, 32> buffer{};
  if (term.kind() == Term::Kind::kInteger) {
    text += Print(term.integer(), buffer);
    return;
  }
  const std::string_view digits = Print(term.real(), buffer);
  text += digits;
  if (digits.find_first_not_of("-0123456789") == std::string_view::npos) text += ".0";
}

}  // namespace

std::string QuoteWord(std::string_view name) {
  if (IsBareWord(name)) return std::string(name);
  std::string text;
  AppendQuoted(text, name, '\'');
  return text;
}

std::string QuoteName(std::string_view name) {
  if (name.empty()) return "unnamed";
  if (name.find_first_not_of("0123456789") == std::string_view::npos) return std::string(name);
  if (name[0] != '$') return QuoteWord(name);
  std::string text;
  AppendQuoted(text, name, '\'');
  return text;
}

void AppendSymbol(std::string& text, Symbol symbol) {
  if (symbol.kind() == SymbolKind::kDistinctObject) {
    AppendQuoted(text, symbol.name(), '"');
  } else if (IsBareWord(symbol.name())) {
    text += symbol.name();
  } else {
    AppendQuoted(text, symbol.name(), '\'');
  }
}

void AppendVariable(std::string& text, Variable variable, std::span<const std::string> names) {
  if (variable < names.size() && !names[variable].empty()) {
    text += names[variable];
    return;
  }
  std::array<char, 32> buffer{};
  text += 'X';
  text += Print(variable, buffer);
}

void AppendTerm(std::string& text, const Term& term, std::span<const std::string> names) {
  std::vector<std::span<const Term>> open;  // What is left of the argument lists begun.
  const Term* next = &term;
  while (true) {
    if (next->is_variable()) {
      AppendVariable(text, next->variable(), names);
    } else if (next->is_number()) {
      AppendNumber(text, *next);
    } else {
      AppendSymbol(text, next->symbol());
      if (!next->arguments().empty()) {
        text += '(';
        open.push_back(next->arguments());
        next = &open.back().front();
        continue;
      }
    }
    while (!open.empty() && open.back().size() == 1) {
      text += ')';
      open.pop_back();
    }
    if (open.empty()) return;
    text += ", ";
    open.back() = open.back().subspan(1);
    next = &open.back().front();
  }
}

std::string ToString(const Term& term, std::span<const std::string> variable_names) {
  std::string text;
  AppendTerm(text, term, variable_names);
  return text;
}

}  // namespace latchwork::logic
