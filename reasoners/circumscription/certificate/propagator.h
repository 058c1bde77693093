// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_CERTIFICATE_PROPAGATOR_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_CERTIFICATE_PROPAGATOR_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/circumscription/theory/compiled_theory.h"

namespace latchwork::circumscription {

/// Unit propagation over the clauses of a theory. Two literals of each clause are watched, so that
/// going back costs no more than the literals taken back; no memory is allocated after warm-up.
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
  /// Of a clause of two literals, `other` is the other one and `start` is kBinary.
  struct Watch {
    Literal other;
    std::uint32_t start;
    std::uint32_t size;
  };
  static constexpr std::uint32_t kBinary = UINT32_MAX;

  std::size_t Index(Literal literal) const {
    return static_cast<std::size_t>(static_cast<std::int64_t>(middle_) + literal);
  }
  void Push(Literal literal) {
    values_[Index(literal)] = 1;
    values_[Index(-literal)] = -1;
    trail_[size_++] = literal;
  }
  void AddClause(std::span<const Literal> clause);
  bool Visit(Literal falsified);
  bool MoveWatch(const Watch& watch, Literal falsified);

  std::size_t middle_;
  std::vector<std::int8_t> values_;  ///< By literal, from -atoms to atoms.
  std::vector<std::vector<Watch>> watches_;
  std::vector<Literal> literals_;  ///< Of the clauses of three and more; the first two are watched.
  std::vector<Literal> trail_;     ///< Has room for all atoms.
  std::size_t size_ = 0;           ///< Of trail_, as far as it is filled.
  std::size_t next_ = 0;           ///< In trail_: what Propagate has not seen yet.
  std::size_t root_ = 0;           ///< Trail length that Reset goes back to.
  std::vector<std::int8_t> root_values_;
  bool refuted_ = false;  ///< The clauses alone are contradictory.
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_CERTIFICATE_PROPAGATOR_H_
