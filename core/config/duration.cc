// SPDX-License-Identifier: BSD-3-Clause
#include "core/config/duration.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>

namespace latchwork::config {
namespace {

struct Unit {
  std::string_view name;
  std::uint64_t microseconds;
};
constexpr std::array<Unit, 5> kUnits = {
    {{"us", 1}, {"ms", 1'000}, {"s", 1'000'000}, {"min", 60'000'000}, {"h", 3'600'000'000}}};
constexpr std::size_t kMaxDigits = 9;

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// Takes the digits at the start of `text`; nothing when there are none or too many.
std::optional<std::uint64_t> TakeDigits(std::string_view& text, std::size_t max,
                                        std::size_t& count) {
  std::uint64_t value = 0;
  for (count = 0; count < text.size() && IsDigit(text[count]); ++count) {
    if (count == max) return std::nullopt;
    value = 10 * value + static_cast<std::uint64_t>(text[count] - '0');
  }
  text.remove_prefix(count);
  if (count == 0) return std::nullopt;
  return value;
}

}  // namespace

std::optional<std::uint64_t> ParseDuration(std::string_view text) {
  std::size_t digits = 0;
  const auto whole = TakeDigits(text, kMaxDigits, digits);
  if (!whole) return std::nullopt;
  std::uint64_t fraction = 0;
  std::uint64_t scale = 1;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    const auto taken = TakeDigits(text, kMaxDigits, digits);
    if (!taken) return std::nullopt;
    fraction = *taken;
    for (std::size_t i = 0; i < digits; ++i) scale *= 10;
  }
  for (const Unit& unit : kUnits) {
    if (text != unit.name) continue;
    if (fraction * unit.microseconds % scale != 0) return std::nullopt;
    return *whole * unit.microseconds + fraction * unit.microseconds / scale;
  }
  return std::nullopt;
}

std::string FormatDuration(std::uint64_t microseconds) {
  if (microseconds % 1'000'000 == 0) return fmt::format("{}s", microseconds / 1'000'000);
  if (microseconds % 1'000 == 0) return fmt::format("{}ms", microseconds / 1'000);
  return fmt::format("{}us", microseconds);
}

}  // namespace latchwork::config
