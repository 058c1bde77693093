// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/lint/name_words.h"

#include <cstddef>

#include "latchwork/logic/diagnostic.h"
#include "reasoners/icarus/language/source_tree.h"

namespace latchwork::icarus {

namespace {

bool IsUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool IsLower(char c) { return c >= 'a' && c <= 'z'; }

}  // namespace

std::vector<std::string> WordsOf(std::string_view name) {
  std::vector<std::string> words;
  bool begins = true;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (c == '_' || c == '-') {
      begins = true;
      continue;
    }
    if (begins || (i > 0 && IsUpper(c) && IsLower(name[i - 1]))) words.emplace_back();
    begins = false;
    words.back() += c;
  }
  for (std::string& word : words) word = Fold(word);
  return words;
}

bool IsSlip(std::string_view written, std::string_view meant) {
  const std::vector<std::string> left = WordsOf(written);
  const std::vector<std::string> right = WordsOf(meant);
  if (left == right) return true;
  if (written.empty() || meant.empty() || IsUpper(written[0]) != IsUpper(meant[0])) return false;
  if (left.size() != right.size()) return true;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i] != right[i] && logic::NearestName(left[i], {right[i]}).empty()) return false;
  }
  return true;
}

}  // namespace latchwork::icarus
