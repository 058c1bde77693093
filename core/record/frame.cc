// SPDX-License-Identifier: BSD-3-Clause
#include "core/record/frame.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>
#include <nlohmann/json.hpp>

namespace latchwork::record {
namespace {

constexpr std::size_t kLengthDigits = 8;
constexpr std::size_t kChecksumDigits = 16;
static_assert(kFramePrefix == kLengthDigits + 1 + kChecksumDigits + 1);

std::optional<std::uint64_t> ParseHex(std::string_view digits) {
  std::uint64_t value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

/// How deep the brackets outside of texts are nested.
std::size_t Nesting(std::string_view json) {
  std::size_t deepest = 0;
  std::size_t depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"') {
      in_text = !in_text;
    } else if (in_text) {
      if (c == '\\') ++i;
    } else if (c == '{' || c == '[') {
      deepest = std::max(deepest, ++depth);
    } else if ((c == '}' || c == ']') && depth > 0) {
      --depth;
    }
  }
  return deepest;
}

}  // namespace

void AppendFrame(std::string_view json, std::uint64_t checksum, std::string& out) {
  fmt::format_to(std::back_inserter(out), "{:08x} {:016x} ", json.size(), checksum);
  out += json;
  out += '\n';
}

std::optional<FramePrefix> ParseFramePrefix(std::string_view bytes) {
  const auto length = ParseHex(bytes.substr(0, kLengthDigits));
  const auto checksum = ParseHex(bytes.substr(kLengthDigits + 1, kChecksumDigits));
  if (!length || !checksum || *length > kMaxFrameBytes) return std::nullopt;
  if (bytes[kLengthDigits] != ' ' || bytes[kFramePrefix - 1] != ' ') return std::nullopt;
  return FramePrefix{*length, *checksum};
}

bool IsShallowJson(std::string_view json) {
  return Nesting(json) <= kMaxNesting && nlohmann::json::accept(json);
}

}  // namespace latchwork::record
