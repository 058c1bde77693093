// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_FINGERPRINT_H_
#define LATCHWORK_PTTP_TABLEAU_FINGERPRINT_H_

#include <cstdint>

namespace latchwork::pttp {

/// A byte of the functor at each of eight places in the arguments of a literal, the same ones for
/// all literals of a predicate. A place with a variable is left out. By it most unifications and
/// comparisons that would fail are not begun.
class Fingerprint {
 public:
  static constexpr std::uint32_t kPlaces = 8;

  void Set(std::uint32_t place, std::uint32_t functor) {
    functors_ |= std::uint64_t{functor & 0xffU} << (8 * place);
    known_ |= std::uint64_t{0xff} << (8 * place);
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

/// A place of a fingerprint where a goal's term is not known before the search.
struct Probe {
  static constexpr std::uint32_t kNone = 0xffffffffU;
  static constexpr std::uint8_t kNowhere = 0xff;

  std::uint32_t argument = kNone;  ///< It is this argument of the goal;
  std::uint32_t variable = 0;      ///< else this variable of the clause (slot + 1);
  std::uint8_t above = kNowhere;   ///< or, unless kNowhere, in the term at this place
  std::uint8_t index = 0;          ///< this argument.
  std::uint8_t place = 0;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_FINGERPRINT_H_
