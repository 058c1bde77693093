// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_FINGERPRINT_H_
#define LATCHWORK_CONFIG_FINGERPRINT_H_

#include <cstdint>
#include <string>
#include <string_view>

namespace latchwork::config {

/// FNV-1a over 128 bits (Fowler, Noll, Vo). Tells texts apart that differ by accident, not by
/// malice.
class Fingerprint {
 public:
  /// Adds a text and its length, so that the border between two texts counts.
  void Add(std::string_view text);
  /// 32 hexadecimal digits.
  std::string Hex() const;

 private:
  void AddByte(unsigned char byte);

  std::uint64_t high_ = 0x6c62272e07bb0142ULL;
  std::uint64_t low_ = 0x62b821756295c58dULL;
};

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_FINGERPRINT_H_
