// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/unified_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace latchwork::app {

namespace {

constexpr std::size_t kContext = 3;
/// Larger differences are given as one replacement.
constexpr std::size_t kMostCells = 1U << 24U;

using Lines = std::vector<std::string_view>;

struct Edit {
  char sign = ' ';
  std::string_view line;
};

Lines Split(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    lines.push_back(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  return lines;
}

/// The edits of a part in which the first and the last lines differ: by the longest common
/// subsequence, found from the end.
void Middle(const Lines& a, std::size_t a0, std::size_t a1, const Lines& b, std::size_t b0,
            std::size_t b1, std::vector<Edit>& edits) {
  const std::size_t rows = a1 - a0;
  const std::size_t columns = b1 - b0;
  const bool small = (rows + 1) * (columns + 1) <= kMostCells;
  std::vector<std::uint32_t> common(small ? (rows + 1) * (columns + 1) : 0);
  const auto at = [&](std::size_t i, std::size_t j) -> std::uint32_t& {
    return common[i * (columns + 1) + j];
  };
  for (std::size_t i = small ? rows : 0; i-- > 0;) {
    for (std::size_t j = columns; j-- > 0;) {
      at(i, j) =
          a[a0 + i] == b[b0 + j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
    }
  }
  std::size_t i = 0;
  std::size_t j = 0;
  while (small && i < rows && j < columns) {
    if (a[a0 + i] == b[b0 + j]) {
      edits.push_back({' ', a[a0 + i]});
      ++i;
      ++j;
    } else if (at(i + 1, j) >= at(i, j + 1)) {
      edits.push_back({'-', a[a0 + i++]});
    } else {
      edits.push_back({'+', b[b0 + j++]});
    }
  }
  while (i < rows) edits.push_back({'-', a[a0 + i++]});
  while (j < columns) edits.push_back({'+', b[b0 + j++]});
}

std::vector<Edit> Edits(const Lines& a, const Lines& b) {
  std::size_t head = 0;
  while (head < std::min(a.size(), b.size()) && a[head] == b[head]) ++head;
  std::size_t tail = 0;
  while (tail < std::min(a.size(), b.size()) - head &&
         a[a.size() - 1 - tail] == b[b.size() - 1 - tail]) {
    ++tail;
  }
  std::vector<Edit> edits;
  for (std::size_t i = 0; i < head; ++i) edits.push_back({' ', a[i]});
  Middle(a, head, a.size() - tail, b, head, b.size() - tail, edits);
  for (std::size_t i = a.size() - tail; i < a.size(); ++i) edits.push_back({' ', a[i]});
  return edits;
}

/// `3,4`: where a hunk begins and how many lines it has.
std::string Range(std::size_t before, std::size_t count) {
  return fmt::format("{},{}", count == 0 ? before : before + 1, count);
}

std::string Hunk(const std::vector<Edit>& edits, std::size_t begin, std::size_t end) {
  std::size_t old_before = 0;
  std::size_t new_before = 0;
  std::size_t old_count = 0;
  std::size_t new_count = 0;
  for (std::size_t i = 0; i < end; ++i) {
    (i < begin ? old_before : old_count) += edits[i].sign != '+' ? 1 : 0;
    (i < begin ? new_before : new_count) += edits[i].sign != '-' ? 1 : 0;
  }
  std::string text =
      fmt::format("@@ -{} +{} @@\n", Range(old_before, old_count), Range(new_before, new_count));
  for (std::size_t i = begin; i < end; ++i) {
    text += edits[i].sign;
    text += edits[i].line;
    if (!edits[i].line.ends_with('\n')) text += "\n\\ No newline at end of file\n";
  }
  return text;
}

}  // namespace

std::string UnifiedDiff(std::string_view before, std::string_view after, const std::string& file) {
  const std::vector<Edit> edits = Edits(Split(before), Split(after));
  std::string text;
  std::size_t i = 0;
  while (i < edits.size()) {
    if (edits[i].sign == ' ') {
      ++i;
      continue;
    }
    const std::size_t begin = i - std::min(i, kContext);
    std::size_t end = i;
    for (std::size_t same = 0; i < edits.size() && same <= 2 * kContext; ++i) {
      same = edits[i].sign == ' ' ? same + 1 : 0;
      if (same == 0) end = i + 1;
    }
    const std::size_t stop = std::min(end + kContext, edits.size());
    text += Hunk(edits, begin, stop);
    i = stop;
  }
  if (text.empty()) return text;
  return fmt::format("--- {}\n+++ {}\n", file, file) + text;
}

}  // namespace latchwork::app
