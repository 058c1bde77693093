// SPDX-License-Identifier: BSD-3-Clause
#include "core/record/json_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/logic/print.h"
#include "core/logic/utf8.h"

namespace latchwork::record {
namespace {

bool IsPlain(char c) { return c >= ' ' && c < '\x7f' && c != '"' && c != '\\'; }

template <typename Value>
void AppendNumber(std::string& text, Value value) {
  std::array<char, 32> buffer{};
  const char* const begin = buffer.data();
  const char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  text.append(begin, end);
}

void AppendControl(std::string& text, char c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  text += "\\u00";
  text += kDigits[byte >> 4U];
  text += kDigits[byte & 15U];
}

}  // namespace

/// A value or key follows another one unless a bracket or a key stands before it.
void JsonWriter::Separate() {
  if (text_.empty()) return;
  const char last = text_.back();
  if (last != '{' && last != '[' && last != ':') text_ += ',';
}

void JsonWriter::Begin(char bracket) {
  Separate();
  text_ += bracket;
}

void JsonWriter::Key(std::string_view name) {
  Text(name);
  text_ += ':';
}

void JsonWriter::Text(std::string_view text) {
  Separate();
  text_ += '"';
  if (std::all_of(text.begin(), text.end(), IsPlain)) {
    text_ += text;
  } else {
    Escape(text);
  }
  text_ += '"';
}

void JsonWriter::Escape(std::string_view text) {
  while (!text.empty()) {
    const char c = text.front();
    std::size_t length = 1;
    if (IsPlain(c)) {
      text_ += c;
    } else if (c == '"' || c == '\\') {
      text_ += '\\';
      text_ += c;
    } else if (c >= 0) {
      AppendControl(text_, c);
    } else if ((length = logic::Utf8Length(text)) != 0) {
      text_ += text.substr(0, length);
    } else {
      text_ += "\\ufffd";
      length = 1;
    }
    text.remove_prefix(length);
  }
}

void JsonWriter::Number(std::uint64_t number) {
  Separate();
  AppendNumber(text_, number);
}

void JsonWriter::Number(double number) {
  Separate();
  if (std::isfinite(number)) {
    AppendNumber(text_, number);
  } else {
    text_ += "null";
  }
}

void JsonWriter::Boolean(bool value) {
  Separate();
  text_ += value ? "true" : "false";
}

void JsonWriter::Fact(const logic::Fact& fact) {
  fact_.clear();
  logic::AppendAtom(fact_, fact, {});
  Text(fact_);
}

void JsonWriter::Facts(std::span<const logic::Fact> facts) {
  Begin('[');
  for (const logic::Fact& fact : facts) Fact(fact);
  End(']');
}

}  // namespace latchwork::record
