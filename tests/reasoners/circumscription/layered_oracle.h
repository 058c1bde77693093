// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_LAYERED_ORACLE_H_
#define LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_LAYERED_ORACLE_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/circumscription/layered/layered_theory.h"

namespace latchwork::circumscription {

/// A set of worlds over up to 15 atoms, a bit for each world. Atoms count from 0.
class Worlds {
 public:
  /// All of them.
  explicit Worlds(std::size_t atoms);
  static Worlds Where(std::size_t atoms, std::size_t atom, bool holds);

  Worlds& operator&=(const Worlds& other);
  Worlds& operator|=(const Worlds& other);
  void Remove(const Worlds& other);
  bool empty() const;
  /// Adds the worlds that differ from one of these in `atom` only.
  void Forget(std::size_t atom);
  /// The worlds in which `atom` does not hold, with it made true.
  Worlds Raised(std::size_t atom) const;

 private:
  std::size_t atoms_;
  std::vector<std::uint64_t> blocks_;
};

/// Definition 1 word by word: for each layer the circumscription over the atoms of all layers, the
/// foreign ones fixed, and of these sets of models the intersection. Shares no code with what it is
/// held against, and makes no use of the fact that layers can be evaluated one by one.
class LayeredOracle {
 public:
  /// Up to 15 atoms, with an ab for each bridge among them.
  explicit LayeredOracle(const LayeredTheory& theory);

  bool HasModel() const { return !models_.empty(); }
  /// Whether all models satisfy the disjunction of literals of layer `layer`.
  bool Entails(std::size_t layer, std::span<const Literal> clause) const;
  static std::size_t AtomCount(const LayeredTheory& theory);

 private:
  std::size_t Place(std::size_t layer, Atom atom) const {
    return first_[layer] + static_cast<std::size_t>(atom) - 1;
  }
  Worlds Satisfying(std::size_t layer, std::span<const Literal> clause) const;
  Worlds Circumscribed(const LayeredTheory& theory, std::size_t layer) const;

  std::size_t atoms_;
  std::vector<std::size_t> first_;
  std::vector<std::size_t> first_abnormal_;
  Worlds models_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_LAYERED_ORACLE_H_
