// SPDX-License-Identifier: BSD-3-Clause
#include "core/config/fingerprint.h"

#include <fmt/format.h>

namespace latchwork::config {

void Fingerprint::AddByte(unsigned char byte) {
  // The prime is 2^88 + 0x13b.
  constexpr std::uint64_t kPrimeLow = 0x13b;
  low_ ^= byte;
  const std::uint64_t bottom = (low_ & 0xffffffffU) * kPrimeLow;
  const std::uint64_t top = (low_ >> 32U) * kPrimeLow + (bottom >> 32U);
  high_ = high_ * kPrimeLow + (top >> 32U) + (low_ << 24U);
  low_ = (top << 32U) | (bottom & 0xffffffffU);
}

void Fingerprint::Add(std::string_view text) {
  for (const char c : text) AddByte(static_cast<unsigned char>(c));
  for (unsigned shift = 0; shift < 64; shift += 8) {
    AddByte(static_cast<unsigned char>(text.size() >> shift));
  }
}

std::string Fingerprint::Hex() const { return fmt::format("{:016x}{:016x}", high_, low_); }

}  // namespace latchwork::config
