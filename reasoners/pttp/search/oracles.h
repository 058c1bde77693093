// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_ORACLES_H_
#define LATCHWORK_PTTP_ORACLES_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/pttp/terms/word.h"
#include "reasoners/pttp/theory/facts.h"
#include "reasoners/pttp/theory/predicates.h"

namespace latchwork::pttp {

/// What closing a ground atom of a minimized predicate gave.
struct Closing {
  enum class Result : std::uint8_t { kAssumedFalse, kProved, kUndetermined };
  Result result = Result::kUndetermined;
  std::size_t assumption = 0;  ///< Index into the decision's assumptions.
};

/// What an attachment gave for one tuple of inputs.
struct Computed {
  FactTable rows;                        ///< Every row is a full argument tuple.
  std::vector<std::size_t> assumptions;  ///< What its own questions rest on.
};

/// What a search asks others: both may run searches of their own, on the same heap above the asking
/// one.
class Oracles {
 public:
  virtual ~Oracles() = default;
  virtual Closing Close(PredicateId predicate, std::span<const Word> arguments) = 0;
  /// The tuples of an attachment's predicate that agree with the ground inputs. Null when it could
  /// not be asked.
  virtual Computed* Compute(PredicateId predicate, std::span<const Word> arguments) = 0;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_ORACLES_H_
