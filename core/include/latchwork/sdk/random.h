// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_RANDOM_H_
#define LATCHWORK_SDK_RANDOM_H_

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace latchwork::sdk {

/// Random numbers as a pure function of (seed, stream name, a, b): a counter-based generator. There
/// is no state to share, to advance or to save, so a stream never shifts because another one was
/// used more. By custom `a` is the tick and `b` numbers the draws within it. Thread rule: const and
/// safe.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name)
      : key_(Mix(seed ^ 0x9e3779b97f4a7c15ULL)) {
    for (const char c : name) key_ = Mix(key_ ^ static_cast<unsigned char>(c));
  }

  std::uint64_t Bits(std::uint64_t a, std::uint64_t b = 0) const {
    return Mix(Mix(key_ + 0xd1342543de82ef95ULL * a) ^ (0x2545f4914f6cdd1dULL * (b + 1)));
  }
  /// Uniform in [0, 1).
  double Uniform(std::uint64_t a, std::uint64_t b = 0) const {
    return static_cast<double>(Bits(a, b) >> 11U) * 0x1p-53;
  }
  /// Uniform in [low, high).
  double Between(double low, double high, std::uint64_t a, std::uint64_t b = 0) const {
    return low + (high - low) * Uniform(a, b);
  }
  /// Uniform in 0 .. count-1; `count` must not be 0.
  std::uint64_t Index(std::uint64_t count, std::uint64_t a, std::uint64_t b = 0) const {
    return Bits(a, b) % count;
  }
  /// Mean 0, standard deviation 1 (Box and Muller 1958).
  double Gaussian(std::uint64_t a, std::uint64_t b = 0) const {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform(a, 2 * b)));
    return radius * std::cos(2.0 * std::numbers::pi * Uniform(a, 2 * b + 1));
  }

 private:
  static constexpr std::uint64_t Mix(std::uint64_t x) {
    x = (x ^ (x >> 32U)) * 0xd6e8feb86659fd93ULL;
    x = (x ^ (x >> 32U)) * 0xd6e8feb86659fd93ULL;
    return x ^ (x >> 32U);
  }

  std::uint64_t key_;
};

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_RANDOM_H_
