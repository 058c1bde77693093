// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_FINGERPRINT_H_
#define LATCHWORK_LOGIC_FINGERPRINT_H_

#include <cstdint>
#include <string_view>

namespace latchwork::logic {

/// Where fingerprints start (the offset basis of FNV-1a, 64 bits).
inline constexpr std::uint64_t kFingerprintStart = 0xcbf29ce484222325ULL;

/// FNV-1a over 64 bits (Fowler, Noll, Vo) of `bytes`, continuing from the fingerprint of what came
/// before them. Tells texts apart that differ by accident, not by malice.
constexpr std::uint64_t Fingerprint(std::string_view bytes,
                                    std::uint64_t before = kFingerprintStart) {
  constexpr std::uint64_t kPrime = 0x100000001b3ULL;
  for (const char c : bytes) before = (before ^ static_cast<unsigned char>(c)) * kPrime;
  return before;
}

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_FINGERPRINT_H_
