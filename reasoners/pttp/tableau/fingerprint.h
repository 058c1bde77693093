// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_FINGERPRINT_H_
#define LATCHWORK_PTTP_TABLEAU_FINGERPRINT_H_

#include <algorithm>
#include <cstdint>

namespace latchwork::pttp {

/// A byte of the functor at each of eight places of an argument list: the arguments, and the first
/// two arguments of each as far as there is room and goals of the predicate and sign need it. A
/// place with a variable is left out. By it most unifications and comparisons that would fail are
/// not begun.
class Fingerprint {
 public:
  static constexpr std::uint32_t kPlaces = 8;
  static constexpr std::uint32_t kBelow = 2;  ///< How many arguments of an argument are looked at.

  /// The place of the first argument of an argument; kPlaces: there is no room.
  static std::uint32_t PlaceBelow(std::uint32_t arity, std::uint32_t argument) {
    const std::uint32_t place = arity + kBelow * argument;
    return place + kBelow <= kPlaces ? place : kPlaces;
  }

  void Set(std::uint32_t place, std::uint32_t functor) {
    functors_ |= std::uint64_t{functor & 0xffU} << (8 * place);
    known_ |= std::uint64_t{0xff} << (8 * place);
  }
  /// The bytes of places, kPlaces or more have none.
  static std::uint64_t Bytes(std::uint32_t place, std::uint32_t count) {
    std::uint64_t bytes = 0;
    for (std::uint32_t i = place; i < std::min(place + count, kPlaces); ++i) {
      bytes |= std::uint64_t{0xff} << (8 * i);
    }
    return bytes;
  }
  /// The bytes of the places that are known.
  std::uint64_t known() const { return known_; }
  void Keep(std::uint64_t places) {
    functors_ &= places;
    known_ &= places;
  }

  /// Whether no bindings make the terms equal.
  bool Clashes(const Fingerprint& other) const {
    return ((functors_ ^ other.functors_) & known_ & other.known_) != 0;
  }
  /// Whether terms that looked like this once can be identical to those that now look like `now`.
  bool MayEqual(const Fingerprint& now) const {
    return ((functors_ ^ now.functors_) & known_) == 0;
  }

 private:
  std::uint64_t functors_ = 0;
  std::uint64_t known_ = 0;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_FINGERPRINT_H_
