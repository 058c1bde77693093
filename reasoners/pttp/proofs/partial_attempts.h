// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PARTIAL_ATTEMPTS_H_
#define LATCHWORK_PTTP_PARTIAL_ATTEMPTS_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"
#include "reasoners/pttp/proofs/clause_index.h"

namespace latchwork::pttp {

/// A goal that nothing matched, as far as it was known by then.
struct DeadEnd {
  logic::Literal goal;
  std::vector<logic::Literal> above;  ///< The goals that it was needed for, nearest first.
  std::uint32_t solved = 0;           ///< Steps that the attempt had made.
  std::uint32_t open = 0;             ///< Other goals that the attempt had left.
};

struct PartialAttempts {
  std::vector<DeadEnd> dead_ends;  ///< What came nearest to a proof first; no two goals alike.
  bool found_proof = false;
  bool cut_off = false;  ///< There were more attempts to make.
};

/// Tries to contradict the start clauses, deeper and deeper, by backward steps, reductions and
/// arithmetic on numbers, and notes where it could not go on. Equations are matched as they stand.
/// `most_work` bounds how many terms are looked at.
PartialAttempts TryToProve(const ClauseIndex& index, std::span<const std::uint32_t> starts,
                           logic::SymbolTable& symbols, std::uint64_t most_work);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PARTIAL_ATTEMPTS_H_
