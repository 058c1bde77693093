// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_RANDOM_THEORY_H_
#define LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_RANDOM_THEORY_H_

#include <cstdint>
#include <vector>

#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  /// 0 .. sides-1.
  int Roll(int sides) {
    state_ += 0x9E3779B97F4A7C15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EB;
    z ^= z >> 31U;
    return static_cast<int>(z % static_cast<std::uint64_t>(sides));
  }

 private:
  std::uint64_t state_;
};

/// A theory of 1 to `most_atoms` atoms: any split of them, one to three levels, general, definite
/// or positive clauses, few or many.
GroundTheory RandomTheory(Dice& dice, int most_atoms);
/// Up to `most` literals; none at times.
std::vector<Literal> RandomLiterals(Dice& dice, const GroundTheory& theory, int most);
/// Values for the fixed atoms; open at times.
std::vector<Literal> RandomLatches(Dice& dice, const GroundTheory& theory);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_RANDOM_THEORY_H_
