// SPDX-License-Identifier: BSD-3-Clause
#include "core/record/frame.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>

namespace latchwork::record {
namespace {

constexpr std::size_t kLengthDigits = 8;
constexpr std::size_t kHashDigits = 16;
constexpr std::size_t kPrefix = kLengthDigits + 1 + kHashDigits + 1;

std::optional<std::uint64_t> ParseHex(std::string_view digits) {
  std::uint64_t value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

}  // namespace

std::uint64_t Chain(std::uint64_t chain, std::string_view text) {
  constexpr std::uint64_t kPrime = 0x100000001b3ULL;
  for (const char c : text) chain = (chain ^ static_cast<unsigned char>(c)) * kPrime;
  return chain;
}

void AppendFrame(std::string_view json, std::uint64_t hash, std::string& out) {
  fmt::format_to(std::back_inserter(out), "{:08x} {:016x} {}\n", json.size(), hash, json);
}

std::optional<Frame> ParseFrame(std::string_view bytes) {
  if (bytes.size() <= kPrefix) return std::nullopt;
  const auto length = ParseHex(bytes.substr(0, kLengthDigits));
  const auto hash = ParseHex(bytes.substr(kLengthDigits + 1, kHashDigits));
  if (!length || !hash || bytes[kLengthDigits] != ' ' || bytes[kPrefix - 1] != ' ') {
    return std::nullopt;
  }
  if (bytes.size() - kPrefix <= *length || bytes[kPrefix + *length] != '\n') return std::nullopt;
  return Frame{bytes.substr(kPrefix, *length), *hash, kPrefix + *length + 1};
}

}  // namespace latchwork::record
