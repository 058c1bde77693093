// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_THEORY_COMPILED_THEORY_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_THEORY_COMPILED_THEORY_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

/// A ground theory laid out for search: clauses without tautologies and repeated literals, where
/// each literal occurs, and the minimized atoms level by level. Immutable.
class CompiledTheory {
 public:
  explicit CompiledTheory(const GroundTheory& theory);

  std::size_t atom_count() const { return roles_.size(); }
  std::size_t clause_count() const { return starts_.size() - 1; }
  std::span<const Literal> clause(std::size_t index) const {
    return {literals_.data() + starts_[index], starts_[index + 1] - starts_[index]};
  }
  /// The clauses that contain `literal`, in order.
  std::span<const std::uint32_t> Occurrences(Literal literal) const {
    const std::size_t slot = Slot(literal);
    return {occurrences_.data() + occurrence_starts_[slot],
            occurrences_.data() + occurrence_starts_[slot + 1]};
  }

  Role role(Atom atom) const { return roles_[static_cast<std::size_t>(atom) - 1]; }
  /// The place of a minimized atom's level in levels(); of other atoms the number of levels, so
  /// that "at a later level" holds for them too.
  std::size_t level(Atom atom) const { return levels_of_[static_cast<std::size_t>(atom) - 1]; }
  const std::vector<std::vector<Atom>>& levels() const { return levels_; }
  const std::vector<Atom>& fixed() const { return fixed_; }
  const std::vector<Atom>& varying() const { return varying_; }

 private:
  void AddClauses(const GroundTheory& theory);
  void AddLevels(const GroundTheory& theory);
  void AddOccurrences();
  std::size_t Slot(Literal literal) const {
    return 2 * static_cast<std::size_t>(AtomOf(literal)) - (literal < 0 ? 1 : 2);
  }

  std::vector<Role> roles_;
  std::vector<std::size_t> levels_of_;
  std::vector<std::vector<Atom>> levels_;
  std::vector<Atom> fixed_;
  std::vector<Atom> varying_;
  std::vector<Literal> literals_;
  std::vector<std::size_t> starts_;
  std::vector<std::uint32_t> occurrences_;
  std::vector<std::size_t> occurrence_starts_;
};

/// Truth values of all atoms.
class Model {
 public:
  Model() = default;
  explicit Model(std::size_t atoms) : values_(atoms, 0) {}

  bool Holds(Literal literal) const {
    return (values_[static_cast<std::size_t>(AtomOf(literal)) - 1] != 0) == (literal > 0);
  }
  void Make(Literal literal) {
    values_[static_cast<std::size_t>(AtomOf(literal)) - 1] = literal > 0 ? 1 : 0;
  }
  /// The literal of `atom` that holds.
  Literal LiteralOf(Atom atom) const { return Holds(atom) ? atom : -atom; }
  std::size_t size() const { return values_.size(); }
  friend bool operator==(const Model&, const Model&) = default;

 private:
  std::vector<std::uint8_t> values_;
};

/// Whether some literal of `clause` holds in `model`.
bool Satisfies(const Model& model, std::span<const Literal> clause);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_THEORY_COMPILED_THEORY_H_
