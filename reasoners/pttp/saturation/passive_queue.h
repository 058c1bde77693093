// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_PASSIVE_QUEUE_H_
#define LATCHWORK_PTTP_SATURATION_PASSIVE_QUEUE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reasoners/pttp/saturation/clauses.h"
#include "reasoners/pttp/saturation/saturate.h"

namespace latchwork::pttp::saturation {

/// The clauses that wait to be given, in three orders that take turns.
class PassiveQueue {
 public:
  PassiveQueue(const Clauses& clauses, const Options& options);

  void Push(ClauseId id);
  /// The next clause that is still passive, or kNoClause.
  ClauseId Pop();
  std::size_t bytes() const;

 private:
  struct Entry {
    std::uint64_t key;
    ClauseId id;
    /// For a heap whose top is the least.
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.key != b.key ? a.key > b.key : a.id > b.id;
    }
  };
  static constexpr std::size_t kOrders = 3;

  const Clauses& clauses_;
  std::array<unsigned, kOrders> picks_;
  bool goal_first_;
  std::array<std::vector<Entry>, kOrders> heaps_;
  std::size_t order_ = 0;
  unsigned picked_ = 0;
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_PASSIVE_QUEUE_H_
