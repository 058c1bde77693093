// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_ORACLE_H_
#define LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_ORACLE_H_

#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

/// Circumscription straight from its definition, for theories of up to 16 atoms: all models, and
/// of these the ones with no model below. Shares no code with the engine.
class Oracle {
 public:
  /// Bit a - 1: atom a holds.
  using World = std::uint32_t;

  explicit Oracle(const GroundTheory& theory, std::span<const Literal> latches = {});

  const std::vector<World>& models() const { return models_; }
  const std::vector<World>& minimal() const { return minimal_; }
  /// Every minimal model satisfies the disjunction.
  bool EntailsAlways(std::span<const Literal> clause) const;
  /// Some minimal model satisfies the conjunction.
  bool HoldsSomewhere(std::span<const Literal> conjunction) const;

 private:
  bool IsBelow(World lower, World upper) const;
  void FindMinimal();

  World fixed_ = 0;
  std::vector<World> levels_;
  std::vector<World> models_;
  std::vector<World> minimal_;
};

inline bool HoldsIn(Oracle::World world, Literal literal) {
  return ((world >> static_cast<unsigned>(AtomOf(literal) - 1) & 1U) != 0) == (literal > 0);
}

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_ORACLE_H_
