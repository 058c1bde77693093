// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/diagnostic.h"

#include <algorithm>
#include <cstddef>

#include "core/logic/utf8.h"

namespace latchwork::logic {

namespace {

constexpr std::size_t kExcerptBytes = 96;

/// Control characters and bytes that are no UTF-8 become '?', tabs a blank.
std::string Printable(std::string_view text) {
  std::string safe;
  while (!text.empty()) {
    const std::size_t length = Utf8Length(text);
    const auto byte = static_cast<unsigned char>(text[0]);
    if (byte == '\t') {
      safe += ' ';
    } else if (length == 0 || byte < 0x20 || byte == 0x7f) {
      safe += '?';
    } else {
      safe += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return safe;
}

std::size_t Characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

bool Continues(std::string_view text, std::size_t at) {
  return at < text.size() && (text[at] & 0xc0) == 0x80;
}

void AppendExcerpt(std::string& text, const Diagnostic& diagnostic) {
  std::string_view line = diagnostic.excerpt;
  const std::size_t column = diagnostic.place.column == 0 ? 0 : diagnostic.place.column - 1;
  const std::size_t caret = std::min<std::size_t>(column, line.size());
  std::size_t begin = caret > kExcerptBytes / 2 && line.size() > kExcerptBytes
                          ? std::min(caret - kExcerptBytes / 2, line.size() - kExcerptBytes)
                          : 0;
  std::size_t end = std::min(line.size(), begin + kExcerptBytes);
  while (begin < caret && Continues(line, begin)) ++begin;
  while (end > caret && Continues(line, end)) --end;
  const std::string before =
      (begin > 0 ? "..." : "") + Printable(line.substr(begin, caret - begin));
  const std::string after = Printable(line.substr(caret, end - caret));

  const std::string number = std::to_string(diagnostic.place.line);
  const std::string margin(number.size() + 2, ' ');
  text += "  " + number + " | " + before + after + (end < line.size() ? "..." : "") + '\n';
  if (diagnostic.place.column == 0) return;
  text += margin + " | " + std::string(Characters(before), ' ') + "^\n";
}

}  // namespace

std::string Format(const Diagnostic& diagnostic, std::string_view label) {
  const SourcePlace& place = diagnostic.place;
  std::string text = Printable(place.file);
  if (place.line > 0) text += ':' + std::to_string(place.line);
  if (place.line > 0 && place.column > 0) text += ':' + std::to_string(place.column);
  if (!text.empty()) text += ": ";
  text += std::string(label) + ": " + Printable(diagnostic.message) + '\n';
  if (place.line > 0 && !diagnostic.excerpt.empty()) AppendExcerpt(text, diagnostic);
  if (!diagnostic.hint.empty()) text += "  hint: " + Printable(diagnostic.hint) + '\n';
  return text;
}

std::string Format(const Diagnostic& diagnostic) { return Format(diagnostic, "error"); }

std::string Format(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += Format(diagnostic);
  return text;
}

}  // namespace latchwork::logic
