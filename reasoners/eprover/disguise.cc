// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/eprover/disguise.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace latchwork::eprover {
namespace {

constexpr char kMark = '#';

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

bool IsOfWord(char c) {
  return IsDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
}

std::size_t EndOfQuoted(std::string_view text) {
  std::size_t end = 1;
  while (end < text.size() && text[end] != text[0]) end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

/// `-1.5e-07`: a sign belongs to a number at its beginning and behind its `e`.
std::size_t EndOfNumber(std::string_view text) {
  std::size_t end = 1;
  while (end < text.size()) {
    const bool is_sign = (text[end] == '-' || text[end] == '+') && (text[end - 1] | 0x20) == 'e';
    if (!is_sign && text[end] != '.' && !IsOfWord(text[end])) break;
    ++end;
  }
  return end;
}

bool BeginsNumber(std::string_view text) {
  if (text[0] == '-' || text[0] == '+') text.remove_prefix(1);
  return !text.empty() && IsDigit(text[0]);
}

std::size_t EndOfToken(std::string_view text) {
  if (text[0] == '"' || text[0] == '\'') return EndOfQuoted(text);
  if (BeginsNumber(text)) return EndOfNumber(text);
  const auto* const end = std::ranges::find_if_not(text, IsOfWord);
  return std::max<std::size_t>(1, static_cast<std::size_t>(end - text.begin()));
}

/// Text with each of its tokens replaced.
template <typename Replace>
std::string Map(std::string_view text, const Replace& replace) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = EndOfToken(text);
    replace(text.substr(0, end), result);
    text.remove_prefix(end);
  }
  return result;
}

bool IsMarked(std::string_view token) {
  return token.size() > 2 && token[0] == '"' && token[1] == kMark;
}

}  // namespace

std::string Disguise(std::string_view text) {
  return Map(text, [](std::string_view token, std::string& result) {
    if (BeginsNumber(token)) {
      fmt::format_to(std::back_inserter(result), "\"{}{}\"", kMark, token);
    } else if (IsMarked(token)) {
      fmt::format_to(std::back_inserter(result), "\"{}{}", kMark, token.substr(1));
    } else {
      result += token;
    }
  });
}

std::string Undisguise(std::string_view text) {
  return Map(text, [](std::string_view token, std::string& result) {
    if (!IsMarked(token)) {
      result += token;
    } else if (token[2] == kMark) {
      fmt::format_to(std::back_inserter(result), "\"{}", token.substr(2));
    } else {
      result += token.substr(2, token.size() - 3);
    }
  });
}

std::string Axiom(const logic::Clause& clause) {
  logic::Clause named = clause;
  // Names of variables are the reader's; numbered ones cannot clash.
  for (std::size_t i = 0; i < named.variable_names.size(); ++i) {
    named.variable_names[i] = fmt::format("X{}", i);
  }
  return fmt::format("cnf(c, axiom, ({})).\n", Disguise(ToString(named)));
}

std::string Axiom(const logic::Literal& literal) {
  return fmt::format("cnf(f, axiom, ({})).\n", Disguise(ToString(literal)));
}

}  // namespace latchwork::eprover
