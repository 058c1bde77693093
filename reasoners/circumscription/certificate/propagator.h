// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_CERTIFICATE_PROPAGATOR_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_CERTIFICATE_PROPAGATOR_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/circumscription/theory/compiled_theory.h"

namespace latchwork::circumscription {

/// Unit propagation over the clauses of a theory. Of each clause, the literals that are not false
/// are counted and their numbers added by exclusive or, so that the last one is known without a
/// look at the clause; a certificate gives all atoms a value, so all clauses are met anyway. No
/// memory is allocated after construction. `theory` outlives it.
class Propagator {
 public:
  explicit Propagator(const CompiledTheory& theory);

  /// Back to what the clauses alone force.
  void Reset();
  /// Makes `literal` true; false: it is false already. Propagate sees to what follows.
  bool Assign(Literal literal) {
    const std::int8_t value = Value(literal);
    if (value == 0) Push(literal);
    return value >= 0;
  }
  /// False: some clause has no literal left.
  bool Propagate();

  /// 1 true, -1 false, 0 unknown.
  std::int8_t Value(Literal literal) const { return values_[Index(literal)]; }
  /// All true literals, in the order in which they became true.
  std::span<const Literal> trail() const { return {trail_.data(), size_}; }

 private:
  /// The literals of a clause that Propagate has not seen to be false.
  struct Open {
    Literal sum = 0;
    std::uint32_t count = 0;
  };

  std::size_t Index(Literal literal) const {
    return static_cast<std::size_t>(static_cast<std::int64_t>(middle_) + literal);
  }
  void Push(Literal literal) {
    values_[Index(literal)] = 1;
    values_[Index(-literal)] = -1;
    trail_[size_++] = literal;
  }

  const CompiledTheory& theory_;
  std::size_t middle_;
  std::vector<std::int8_t> values_;  ///< By literal, from -atoms to atoms.
  std::vector<Open> open_;           ///< By clause.
  std::vector<Literal> trail_;       ///< Has room for all atoms.
  std::size_t size_ = 0;             ///< Of trail_, as far as it is filled.
  std::size_t next_ = 0;             ///< In trail_: what Propagate has not seen yet.
  std::size_t root_ = 0;             ///< Trail length that Reset goes back to.
  std::vector<std::int8_t> root_values_;
  std::vector<Open> root_open_;
  bool refuted_ = false;  ///< The clauses alone are contradictory.
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_CERTIFICATE_PROPAGATOR_H_
