// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_LATCH_FACTS_H_
#define LATCHWORK_ICARUS_LATCH_FACTS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "latchwork/logic/atom.h"
#include "reasoners/icarus/body/term_bridge.h"
#include "reasoners/icarus/machine/fact_store.h"

namespace latchwork::icarus {

/// What one latch has in short-term memory. Its facts keep the order of the batch, and those that
/// stay from batch to batch are not touched. Allocates while batches grow.
class LatchFacts {
 public:
  explicit LatchFacts(FactStore& memory) : place_(memory.OpenPlace()) {}

  /// False: some of the facts did not get into memory, which is full, or are too deep for it.
  bool Set(std::span<const logic::Fact> facts, TermBridge& bridge, FactStore& memory);

 private:
  std::size_t FirstChange() const;
  bool Changed(std::size_t index) const;

  std::uint64_t place_;
  std::vector<const FactStore::Fact*> held_;  ///< By index in the batch; null: not in memory.
  std::vector<Value> values_;                 ///< Of the new batch.
  Arena arena_;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_LATCH_FACTS_H_
