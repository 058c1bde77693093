// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/passive_queue.h"

#include <algorithm>

namespace latchwork::pttp::saturation {

PassiveQueue::PassiveQueue(const Clauses& clauses, const Options& options)
    : clauses_(clauses),
      picks_{options.size_picks, options.goal_picks, options.age_picks},
      goal_first_(options.goal_first) {
  if (picks_ == std::array<unsigned, kOrders>{}) picks_.back() = 1;
}

void PassiveQueue::Push(ClauseId id) {
  const ClauseRecord& record = clauses_.record(id);
  const std::uint64_t behind = goal_first_ && !record.goal ? std::uint64_t{1} << 40U : 0;
  const std::array<std::uint64_t, kOrders> keys{record.size, behind + record.goal_weight, 0};
  for (std::size_t i = 0; i < kOrders; ++i) {
    if (picks_[i] == 0) continue;
    heaps_[i].push_back({keys[i], id});
    std::push_heap(heaps_[i].begin(), heaps_[i].end());
  }
}

ClauseId PassiveQueue::Pop() {
  while (picked_ >= picks_[order_]) {
    order_ = (order_ + 1) % kOrders;
    picked_ = 0;
  }
  ++picked_;
  std::vector<Entry>& heap = heaps_[order_];
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end());
    const ClauseId id = heap.back().id;
    heap.pop_back();
    if (clauses_.record(id).state == State::kPassive) return id;
  }
  return kNoClause;
}

std::size_t PassiveQueue::bytes() const {
  std::size_t entries = 0;
  for (const auto& heap : heaps_) entries += heap.capacity();
  return entries * sizeof(Entry);
}

}  // namespace latchwork::pttp::saturation
